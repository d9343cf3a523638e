# What an embedding program may include, and under which name: engine/X.hpp is <scarp/X.hpp>, kernels/X.hpp is
# <scarp/kernels/X.hpp>, in the build tree as in an installed one. tests/layering reads this list: nothing in it
# may include, however indirectly, a third-party header or a header that is not in it.
set(scarp_public_headers
  engine/boundary/wall_reaction.hpp
  engine/checkpoint/snapshot.hpp
  engine/converge/richardson.hpp
  engine/converge/study.hpp
  engine/custom_model.hpp
  engine/element/element_path.hpp
  engine/energy/energy_balance.hpp
  engine/errors.hpp
  engine/features.hpp
  engine/fos/cut.hpp
  engine/fos/cut_states.hpp
  engine/fos/limit_search.hpp
  engine/fos/strength_reduction.hpp
  engine/integrate/step_report.hpp
  engine/isa_names.hpp
  engine/output/checkpoint_file.hpp
  engine/output/file_mark.hpp
  engine/output/frame_writer.hpp
  engine/output/probe_writer.hpp
  engine/output/results.hpp
  engine/output/run_writer.hpp
  engine/output/text_file.hpp
  engine/particles/field_view.hpp
  engine/particles/particles.hpp
  engine/particles/probe_sample.hpp
  engine/run/checkpoint_writer.hpp
  engine/run/recovery.hpp
  engine/run/run.hpp
  engine/run_options.hpp
  engine/scarp.hpp
  engine/scene/facets.hpp
  engine/scene/scene.hpp
  engine/scene/scene_reader.hpp
  engine/scene/shorthand.hpp
  engine/scene/soil_model.hpp
  engine/simulation.hpp
  engine/step/phase_view.hpp
  engine/step/reduction.hpp
  engine/watch/lost_soil.hpp
  engine/check/stability_margin.hpp
  kernels/constitutive/drucker_prager.hpp
  kernels/constitutive/linear_elastic.hpp
  kernels/constitutive/list.hpp
  kernels/always_inline.hpp
  kernels/constitutive/model.hpp
  kernels/constitutive/mohr_coulomb.hpp
  kernels/constitutive/model_info.hpp
  kernels/constitutive/model_passes.hpp
  kernels/constitutive/parameter_spec.hpp
  kernels/constitutive/principal.hpp
  kernels/constitutive/softening.hpp
  kernels/constitutive/stress_pass.hpp
  kernels/constitutive/stress_rotation.hpp
  kernels/lanes.hpp
  kernels/particle_view.hpp
  kernels/point_math.hpp
  kernels/tensor.hpp)

# The name under <scarp/...> of a header of the repository.
function(scarp_public_name header name)
  string(REGEX REPLACE "^engine/" "" public ${header})
  set(${name} ${public} PARENT_SCOPE)
endfunction()
