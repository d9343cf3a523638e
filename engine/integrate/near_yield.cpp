// SPDX-License-Identifier: BSD-3-Clause
/// Step limiter of the rate forms.
#include "engine/integrate/near_yield.hpp"

#include <algorithm>

#include "engine/parallel.hpp"
#include "kernels/constitutive/yield_return.hpp"

namespace scarp {

using namespace kernels;

double time_to_first_yield(State& state, double dt) {
  constexpr double shortest = 0.1;
  const ParticleView view = particle_view(state);
  const int dimension = state.scene.dimension;
  const auto load = [&](double* const(&from)[6], std::int64_t k) {
    return SymTensor<double>{from[xx][k],
                             from[yy][k],
                             from[zz][k],
                             from[xy][k],
                             dimension == 3 ? from[yz][k] : 0.0,
                             dimension == 3 ? from[zx][k] : 0.0};
  };
  double soonest = dt;
  for (const ParticleGroup& group : state.particles.groups()) {
    const StressPassConstants& c = state.material_constants[group.material];
    const auto scan = [&](std::int64_t begin, std::int64_t end) {
      double least = dt;
      for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
        Tensor<double> l{};
        for (int a = 0; a < dimension; ++a) {
          for (int b = 0; b < dimension; ++b) l.m[a][b] = view.velocity_gradient[3 * a + b][k];
        }
        const SymTensor<double> now = load(view.stress, k), strain = symmetric_part(l);
        const SymTensor<double> trial = now + (2.0 * c.shear_modulus * dt) * deviator(strain) +
                                        isotropic(c.bulk_modulus * dt * trace(strain));
        const double f_now = yield_function(c, root_j2(deviator(now)), trace(now));
        const double f_trial = yield_function(c, root_j2(deviator(trial)), trace(trial));
        if (f_now < 0.0 && f_trial > 0.0) least = std::min(least, dt * f_now / (f_now - f_trial));
      }
      return least;
    };
    soonest =
        std::min(soonest, parallel_reduce(state.threads, group.count, particle_chunk, dt, scan,
                                          [](double& a, double b) { a = std::min(a, b); }));
  }
  return std::max(soonest, shortest * dt);
}

}  // namespace scarp
