// SPDX-License-Identifier: BSD-3-Clause
/// The fused per-particle pass: velocity gradient -> strain and spin -> rotation, the model's
/// update, density, history, and the time levels of the integrator. `T` is the vector type.
#pragma once

#include <cstdint>

#include "kernels/constitutive/model.hpp"
#include "kernels/constitutive/stress_rotation.hpp"
#include "kernels/particle_view.hpp"

namespace scarp::kernels {

/// L M^-1 where det M allows, else L. Equation: K1. 3D form; 2D sets the third row and column to
/// (0, 0, 1).
template <int Dim, class T>
SCARP_INLINE Tensor<T> corrected_gradient(const Tensor<T>& l, const SymTensor<T>& m) {
  const T cxx = m.yy * m.zz - m.yz * m.yz, cxy = m.zx * m.yz - m.xy * m.zz,
          czx = m.xy * m.yz - m.zx * m.yy;
  const T determinant = m.xx * cxx + m.xy * cxy + m.zx * czx;
  const auto usable = determinant >= T(smallest_moment_determinant<Dim>);
  const T inverse_determinant = T(1.0) / choose(usable, determinant, T(1.0));
  const SymTensor<T> i =
      inverse_determinant * SymTensor<T>{cxx, m.xx * m.zz - m.zx * m.zx, m.xx * m.yy - m.xy * m.xy,
                                         cxy, m.xy * m.zx - m.xx * m.yz, czx};
  const T inverse[3][3] = {{i.xx, i.xy, i.zx}, {i.xy, i.yy, i.yz}, {i.zx, i.yz, i.zz}};
  Tensor<T> result;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      const T sum =
          l.m[a][0] * inverse[0][b] + l.m[a][1] * inverse[1][b] + l.m[a][2] * inverse[2][b];
      result.m[a][b] = choose(usable, sum, l.m[a][b]);
    }
  }
  return result;
}

/// L M^-1 for moments that can all be inverted. Equation: K1, K3.
template <class T>
SCARP_INLINE Tensor<T> conjugate_gradient(const Tensor<T>& l, const SymTensor<T>& m) {
  const SymTensor<T> i = inverse_of(m);
  const T inverse[3][3] = {{i.xx, i.xy, i.zx}, {i.xy, i.yy, i.yz}, {i.zx, i.yz, i.zz}};
  Tensor<T> result;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      result.m[a][b] =
          l.m[a][0] * inverse[0][b] + l.m[a][1] * inverse[1][b] + l.m[a][2] * inverse[2][b];
    }
  }
  return result;
}

/// New stress of a point: rotate `stress`, then let the model take the strain. Returns the strain
/// of the leap and its plastic part. Equation: E18, E21 over the time `leap`; Jaumann's rate turns
/// `current`.
template <class T>
struct PointStrain {
  SymTensor<T> total, plastic;
};
template <class Model, class T>
SCARP_INLINE PointStrain<T> advance_stress_point(
    const StressPassConstants& c, const typename Model::Constants& constants,
    const Tensor<T>& gradient, const SymTensor<T>& current, const SymTensor<T>& diffusion,
    const T& density, History<T, Model::state_fields.size()>& history, SymTensor<T>& stress) {
  const T leap(c.leap);
  const Spin<T> spin = antisymmetric_part(gradient);
  const StrainIncrement<T> step{leap * symmetric_part(gradient), diffusion, density, c.leap};
  if (c.hughes_winget) {
    stress = rotated(stress, hughes_winget_rotation(spin, leap));
  } else {
    stress = stress + leap * jaumann_rate(current, spin);
  }
  return {step.strain, Model::update(constants, step, stress, history)};
}

/// Loads and stores of one vector of particles.
template <class T, int Dim>
struct ParticleLoads {
  static constexpr int stress_components = Dim == 2 ? 4 : 6;

  template <class Pointer>
  static SCARP_INLINE SymTensor<T> tensor(Pointer const (&from)[6], std::size_t k) {
    SymTensor<T> s{T::load_aligned(from[0] + k),
                   T::load_aligned(from[1] + k),
                   T::load_aligned(from[2] + k),
                   T::load_aligned(from[3] + k),
                   T(0.0),
                   T(0.0)};
    if constexpr (Dim == 3) {
      s.yz = T::load_aligned(from[4] + k);
      s.zx = T::load_aligned(from[5] + k);
    }
    return s;
  }
  static SCARP_INLINE void store(double* const (&to)[6], std::size_t k, const SymTensor<T>& s) {
    s.xx.store_aligned(to[0] + k);
    s.yy.store_aligned(to[1] + k);
    s.zz.store_aligned(to[2] + k);
    s.xy.store_aligned(to[3] + k);
    if constexpr (Dim == 3) {
      s.yz.store_aligned(to[4] + k);
      s.zx.store_aligned(to[5] + k);
    }
  }
  static SCARP_INLINE Tensor<T> gradient(const ParticleView& p, const StressPassConstants& c,
                                         std::size_t k) {
    Tensor<T> l;
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) {
        l.m[a][b] =
            a < Dim && b < Dim ? T::load_aligned(p.velocity_gradient[3 * a + b] + k) : T(0.0);
      }
    }
    if (!c.gradient_correction) return l;
    return p.force_moment[xx] != nullptr ? conjugate_gradient(l, moment(p, k))
                                         : corrected_gradient<Dim>(l, moment(p, k));
  }
  static SCARP_INLINE SymTensor<T> moment(const ParticleView& p, std::size_t k) {
    SymTensor<T> m{T::load_aligned(p.moment[xx] + k),
                   T::load_aligned(p.moment[yy] + k),
                   T(1.0),
                   T::load_aligned(p.moment[xy] + k),
                   T(0.0),
                   T(0.0)};
    if constexpr (Dim == 3) {
      m.zz = T::load_aligned(p.moment[zz] + k);
      m.yz = T::load_aligned(p.moment[yz] + k);
      m.zx = T::load_aligned(p.moment[zx] + k);
    }
    return m;
  }
  /// Turns the moment, which is that of the middle of the step, with the spin to its end, where the
  /// force is summed. Equation: K3.
  static SCARP_INLINE void turn_moment(const ParticleView& p, const StressPassConstants& c,
                                       const Tensor<T>& gradient, std::size_t k) {
    const SymTensor<T> m = rotated(
        moment(p, k), hughes_winget_rotation(antisymmetric_part(gradient), T(0.5 * c.leap)));
    m.xx.store_aligned(p.force_moment[xx] + k);
    m.yy.store_aligned(p.force_moment[yy] + k);
    m.xy.store_aligned(p.force_moment[xy] + k);
    if constexpr (Dim == 3) {
      m.zz.store_aligned(p.force_moment[zz] + k);
      m.yz.store_aligned(p.force_moment[yz] + k);
      m.zx.store_aligned(p.force_moment[zx] + k);
    }
  }
  /// Diffusion increment with its lithostatic part: psi = sigma_i - sigma_j + rho g.x_ij T.
  /// Equation: D1.
  static SCARP_INLINE SymTensor<T> diffusion(const ParticleView& p, const StressPassConstants& c,
                                             const T& density, std::size_t k) {
    const T zero(0.0);
    if (c.diffusion_cap == 0.0) return {zero, zero, zero, zero, zero, zero};
    const double* g = c.gravity;
    const double square = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    const double share = square > 0.0 ? (1.0 - c.k0) / square : 0.0;
    const T fall = density * T::load_aligned(p.diffusion_slope + k);
    SymTensor<T> rate = tensor(p.diffusion_rate, k);
    rate = rate + fall * SymTensor<T>{T(c.k0 + share * g[0] * g[0]), T(c.k0 + share * g[1] * g[1]),
                                      T(c.k0 + share * g[2] * g[2]), T(share * g[0] * g[1]),
                                      T(share * g[1] * g[2]),        T(share * g[2] * g[0])};
    return T(c.leap) * rate;
  }
};

/// Stress, density, history and work of one vector of particles from base stress and density. The
/// history goes on from the present level whatever the base: it takes the new share of the change
/// over the leap. Returns how often the density bounds acted.
template <class Model, class T, int Dim>
SCARP_INLINE unsigned advance_material(const ParticleView& p, const StressPassConstants& c,
                                       const typename Model::Constants& model, std::size_t k,
                                       const Tensor<T>& gradient, const SymTensor<T>& base_stress,
                                       const T& base_density, SymTensor<T>& stress, T& density) {
  using Loads = ParticleLoads<T, Dim>;
  const SymTensor<T> current = Loads::tensor(p.stress, k);
  const T density_now = T::load_aligned(p.density + k);
  const SymTensor<T> diffusion = Loads::diffusion(p, c, density_now, k);
  History<T, Model::state_fields.size()> history;
  for (std::size_t h = 0; h < Model::state_fields.size(); ++h)
    history.now[h] = T::load_aligned(p.history[h] + k);
  if (p.strain_rate[xx] != nullptr) Loads::store(p.strain_rate, k, symmetric_part(gradient));
  stress = base_stress;
  const PointStrain<T> strain = advance_stress_point<Model>(c, model, gradient, current, diffusion,
                                                            density_now, history, stress);
  const T share(c.plastic_share);
  for (std::size_t h = 0; h < Model::state_fields.size(); ++h)
    (history.now[h] + share * history.change[h]).store_aligned(p.history[h] + k);
  const ElasticModuli moduli = Model::moduli(model);
  if (p.stress_work != nullptr) {
    const SymTensor<T> mean = (T(0.5) * share / density_now) * (base_stress + stress);
    (T::load_aligned(p.stress_work + k) + contract(mean, strain.total))
        .store_aligned(p.stress_work + k);
    if constexpr (Model::yields) {
      (T::load_aligned(p.plastic_work + k) + contract(mean, strain.plastic))
          .store_aligned(p.plastic_work + k);
    }
    if (p.diffusion_work != nullptr) {
      (T::load_aligned(p.diffusion_work + k) - contract(mean, elastic_strain(moduli, diffusion)))
          .store_aligned(p.diffusion_work + k);
    }
  }
  if (c.diffusion_cap > 0.0) {
    const SymTensor<T> rate = deviator(symmetric_part(gradient));
    const T h(c.smoothing_length);
    const T sound_speed = root(T(moduli.wave_modulus()) / density_now);
    const T gate = T(c.diffusion_shear_gate) * h * h * root(T(2.0) * contract(rate, rate));
    smaller(T(c.diffusion_cap) * h * sound_speed, gate).store_aligned(p.diffusivity + k);
  }
  if (!c.gradient_correction) {
    density = base_density + T(c.leap) * T::load_aligned(p.density_rate + k);
    return 0;
  }
  const T free = base_density - density_now * trace(strain.total);
  density = smaller(larger(free, T(c.density_minimum)), T(c.density_maximum));
  const auto bounded = density != free;
  if (none_of(bounded)) return 0;
  alignas(64) double change[T::size];
  (density - free).store_aligned(change);
  unsigned count = 0;
  for (double value : change) count += value != 0.0;
  return count;
}

/// Verlet step of particles [begin, end): Eq. 28 over two steps or Eq. 29 over one; the damping
/// acts on the mean of the old and new velocity, so that it is stable for any step. Levels: (n-1,
/// n) -> (n, n+1). Pre: begin and end are multiples of the vector's size; arrays are 64-byte
/// aligned. Errors: none.
template <class T, int Dim, class Model>
std::uint64_t advance_verlet(const ParticleView& p, const StressPassConstants& c,
                             const VerletConstants& v, std::size_t begin, std::size_t end) {
  using Loads = ParticleLoads<T, Dim>;
  const auto model = unpacked<typename Model::Constants>(c.model);
  std::uint64_t bounded = 0;
  const double half_damping = 0.5 * v.damping * c.leap;
  const T keep((1.0 - half_damping) / (1.0 + half_damping)), gain(c.leap / (1.0 + half_damping));
  for (std::size_t k = begin; k < end; k += T::size) {
    const SymTensor<T> current = Loads::tensor(p.stress, k);
    const T density_now = T::load_aligned(p.density + k);
    const SymTensor<T> base = v.leaps ? Loads::tensor(p.previous_stress, k) : current;
    const T base_density = v.leaps ? T::load_aligned(p.previous_density + k) : density_now;
    SymTensor<T> stress;
    T density;
    bounded += advance_material<Model, T, Dim>(p, c, model, k, Loads::gradient(p, c, k), base,
                                               base_density, stress, density);
    for (int a = 0; a < Dim; ++a) {
      const T now = T::load_aligned(p.velocity[a] + k);
      const T base_velocity = v.leaps ? T::load_aligned(p.previous_velocity[a] + k) : now;
      const T acceleration = T::load_aligned(p.acceleration[a] + k) + T(c.gravity[a]);
      const T total = acceleration - T(v.damping) * now;
      const T position =
          T::load_aligned(p.position[a] + k) + T(v.dt) * (now + T(0.5 * v.dt) * total);
      position.store_aligned(p.position[a] + k);
      now.store_aligned(p.previous_velocity[a] + k);
      (keep * base_velocity + gain * acceleration).store_aligned(p.velocity[a] + k);
    }
    Loads::store(p.previous_stress, k, current);
    Loads::store(p.stress, k, stress);
    density_now.store_aligned(p.previous_density + k);
    density.store_aligned(p.density + k);
  }
  return bounded;
}

/// Stress and density of particles [begin, end) over a whole step from rates at its middle
/// (kick-drift-kick).
template <class T, int Dim, class Model>
std::uint64_t advance_stress(const ParticleView& p, const StressPassConstants& c, std::size_t begin,
                             std::size_t end) {
  using Loads = ParticleLoads<T, Dim>;
  const auto model = unpacked<typename Model::Constants>(c.model);
  std::uint64_t bounded = 0;
  for (std::size_t k = begin; k < end; k += T::size) {
    SymTensor<T> stress;
    T density;
    const Tensor<T> gradient = Loads::gradient(p, c, k);
    if (p.force_moment[xx] != nullptr) Loads::turn_moment(p, c, gradient, k);
    bounded += advance_material<Model, T, Dim>(p, c, model, k, gradient, Loads::tensor(p.stress, k),
                                               T::load_aligned(p.density + k), stress, density);
    Loads::store(p.stress, k, stress);
    density.store_aligned(p.density + k);
  }
  return bounded;
}

}  // namespace scarp::kernels
