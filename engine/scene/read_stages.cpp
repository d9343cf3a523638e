// SPDX-License-Identifier: BSD-3-Clause
/// The course of a run: [initial], [[stage]], [[probe]], [output], [checkpoint], [run].
#include <algorithm>

#include "engine/scene/read_parts.hpp"

namespace scarp::input {
namespace {

using kernels::Unit;

void read_strength(const Value& value, Stage& stage) {
  if (!value.is_table()) {
    stage.strength_reduction = value.number(Unit::none);
    return;
  }
  for (const std::string_view material : value.keys()) {
    stage.material_strength_reduction[std::string(material)] =
        value.peek(material)->number(Unit::none);
  }
}

Stage read_stage(const Value& item, bool last) {
  const Table table = item.table(
      {"name", "until", "duration", "rest_velocity", "strength_reduction", "damping", "reset"});
  Stage stage;
  stage.name = table.require("name", "\"fail\"").text();
  const auto duration = table.find("duration");
  if (const auto until = table.find("until")) {
    until->choice("rest");
    stage.until = StageEnd::rest;
  } else if (!duration) {
    table.require("duration", "\"10 s\" (or until = \"rest\")");
  }
  if (duration) stage.duration = duration->number(Unit::time);
  if (stage.until == StageEnd::rest && stage.duration == 0.0) stage.duration.reset();
  if (const auto speed = table.find("rest_velocity")) {
    stage.rest_velocity = speed->number(Unit::velocity);
    if (stage.until != StageEnd::rest) speed->fail("it needs until = \"rest\". Try without it.");
  }
  if (const auto strength = table.find("strength_reduction")) read_strength(*strength, stage);
  if (const auto damping = table.find("damping")) {
    if (damping->is_text()) {
      damping->choice("auto");
    } else {
      stage.damping = damping->number(Unit::none);
      if (*stage.damping < 0.0) damping->fail("it is negative. Try 0 or more [1/s], or \"auto\".");
    }
  }
  const auto reset = table.find("reset");
  stage.reset_after = reset ? reset->boolean() : stage.until == StageEnd::rest && !last;
  return stage;
}

}  // namespace

void read_initial(const Value& section, Scene& scene) {
  const Table table = section.table({"stress", "k0", "uniform"});
  const Value stress = table.require("stress", "\"geostatic\", \"uniform\" or \"zero\"");
  scene.initial_stress = static_cast<InitialStress>(stress.choice("zero|geostatic|uniform"));
  if (scene.initial_stress == InitialStress::uniform) {
    // Order xx, yy, zz, xy, yz, zx; the last two are zero in plane strain.
    const std::size_t count = scene.dimension == 2 ? 4 : 6;
    const auto values = table
                            .require("uniform", count == 4 ? "[\"-10 kPa\", \"-10 kPa\", 0, 0]"
                                                           : "[\"-10 kPa\", 0, 0, 0, 0, 0]")
                            .numbers(Unit::pressure, count);
    std::copy(values.begin(), values.end(), scene.uniform_stress.begin());
  } else if (const auto uniform = table.find("uniform")) {
    uniform->fail("it needs stress = \"uniform\". Try without it.");
  }
  if (const auto k0 = table.find("k0")) {
    if (scene.initial_stress != InitialStress::geostatic) {
      k0->fail("it needs stress = \"geostatic\". Try without it.");
    }
    scene.initial_k0 = k0->number(Unit::none);
    if (!(*scene.initial_k0 >= 0.0)) k0->fail("it is negative. Try 0.5, or without it.");
  }
}

std::vector<Stage> read_stages(const std::vector<Value>& items) {
  std::vector<Stage> stages;
  for (const Value& item : items)
    stages.push_back(read_stage(item, stages.size() + 1 == items.size()));
  return stages;
}

Probe read_probe(const Value& item, int dimension) {
  const Table table = item.table({"name", "at"});
  Probe probe;
  probe.name = table.require("name", "\"crest\"").text();
  probe.at = read_vector(table.require("at", dimension == 2 ? "[1, 2]" : "[1, 2, 3]"), Unit::length,
                         dimension);
  probe.line = item.line();
  return probe;
}

Output read_output(const Value& section) {
  const Table table = section.table({"every", "probes_every", "frames", "energy"});
  Output output;
  if (const auto every = table.find("every")) {
    output.frame_interval = unless_zero(every->number(Unit::time));
  }
  if (const auto every = table.find("probes_every")) {
    output.probe_interval = unless_zero(every->number(Unit::time));
  }
  if (const auto frames = table.find("frames")) output.frames = frames->boolean();
  if (const auto energy = table.find("energy")) output.energy = energy->boolean();
  return output;
}

Checkpoints read_checkpoints(const Value& section) {
  const Table table = section.table({"every", "wall_every", "on_error"});
  Checkpoints checkpoints;
  if (const auto every = table.find("every")) checkpoints.interval = every->number(Unit::time);
  if (const auto every = table.find("wall_every")) {
    checkpoints.wall_interval = every->number(Unit::time);
  }
  if (const auto action = table.find("on_error")) {
    checkpoints.stop_on_error = action->choice("continue|stop") == 1;
  }
  return checkpoints;
}

int read_retries(const Value& section) {
  const auto retry = section.table({"retry"}).find("retry");
  return retry ? retry->integer() : 0;
}

}  // namespace scarp::input
