// SPDX-License-Identifier: BSD-3-Clause
/// The whole public interface: `#include <scarp/scarp.hpp>`.
///
///     scarp::Simulation simulation(scene);              // scene: made in code, or
///     read_scene(path) while (!simulation.finished()) simulation.step(); const auto position =
///     simulation.field("position");
#pragma once

#include <scarp/version.hpp>

#include "engine/check/stability_margin.hpp"
#include "engine/converge/study.hpp"
#include "engine/element/element_path.hpp"
#include "engine/errors.hpp"
#include "engine/fos/strength_reduction.hpp"
#include "engine/isa_names.hpp"
#include "engine/output/checkpoint_file.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "engine/run/recovery.hpp"
#include "engine/run/run.hpp"
#include "engine/scene/scene.hpp"
#include "engine/scene/scene_reader.hpp"
#include "engine/scene/shorthand.hpp"
#include "engine/simulation.hpp"
