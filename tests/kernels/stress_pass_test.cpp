// SPDX-License-Identifier: BSD-3-Clause
/// Stress pass and Verlet update of every instruction set against the scalar reference, over
/// several steps.
#include "kernels/constitutive/stress_pass_reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "engine/particles/aligned_vector.hpp"
#include "kernels/constitutive/model_info.hpp"
#include "kernels/isa/kernel_table.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

constexpr int row[6] = {0, 1, 2, 0, 1, 2}, column[6] = {0, 1, 2, 1, 2, 0};
constexpr std::size_t count = 64;
constexpr double bulk_modulus = 1e8 / 1.2, shear_modulus = 1e8 / 2.6;  // of every material here

/// Arrays of `count` particles behind a ParticleView; 2D leaves the pointers null that a scene
/// leaves null.
class Arrays {
 public:
  explicit Arrays(int dimension) {
    for (auto& field : fields_) field.assign(count, 0.0);
    std::size_t next = 0;
    const auto take = [&] { return fields_.at(next++).data(); };
    const int components = dimension == 2 ? 4 : 6;
    for (int a = 0; a < dimension; ++a) {
      view.position[a] = take();
      view.velocity[a] = take();
      view.previous_velocity[a] = take();
      view.acceleration[a] = take();
      for (int b = 0; b < dimension; ++b) view.velocity_gradient[3 * a + b] = take();
    }
    for (int c = 0; c < components; ++c) {
      view.stress[c] = take();
      view.previous_stress[c] = take();
      view.diffusion_rate[c] = take();
      if (dimension == 3 || c != zz) view.moment[c] = take();
    }
    for (double** scalar :
         {&view.density, &view.previous_density, &view.history[0], &view.plastic_work,
          &view.diffusion_work, &view.stress_work, &view.diffusivity}) {
      *scalar = take();
    }
    for (const double** scalar : {&view.density_rate, &view.diffusion_slope}) *scalar = take();
  }

  void store(std::size_t k, const ReferencePoint& p) {
    for (int a = 0; a < 3; ++a) {
      put(view.position[a], k, p.position[a]);
      put(view.velocity[a], k, p.velocity[a]);
      put(view.previous_velocity[a], k, p.previous_velocity[a]);
    }
    for (int c = 0; c < 6; ++c) {
      put(view.stress[c], k, p.stress[row[c]][column[c]]);
      put(view.previous_stress[c], k, p.previous_stress[row[c]][column[c]]);
    }
    put(view.density, k, p.density);
    put(view.previous_density, k, p.previous_density);
  }
  void store(std::size_t k, const ReferencePointRates& r) {
    for (int a = 0; a < 3; ++a) {
      put(view.acceleration[a], k, r.acceleration[a]);
      for (int b = 0; b < 3; ++b)
        put(view.velocity_gradient[3 * a + b], k, r.velocity_gradient[a][b]);
    }
    for (int c = 0; c < 6; ++c) {
      put(view.moment[c], k, r.moment[row[c]][column[c]]);
      put(view.diffusion_rate[c], k, r.diffusion_rate[row[c]][column[c]]);
    }
    put(view.density_rate, k, r.density_rate);
    put(view.diffusion_slope, k, r.diffusion_slope);
  }

  ParticleView view{};

 private:
  /// The rates are constant to the pass, not to the test that owns them.
  static void put(const double* field, std::size_t k, double value) {
    if (field != nullptr) const_cast<double*>(field)[k] = value;
  }
  std::array<AlignedVector<double>, 64> fields_;
};

constexpr double degree = 0.017453292519943295;

struct Material {
  std::string label;
  std::string_view model;
  std::vector<double> parameters;

  template <class Model>
  Material(std::string named, const Model& soil) : label(std::move(named)), model(Model::name) {
    for (const double value : values_of(soil)) parameters.push_back(value);
  }
};

DruckerPrager cone_soil(double cohesion, double friction, double dilation) {
  return {1e8, 0.3, cohesion, friction * degree, dilation * degree};
}
MohrCoulomb coulomb_soil(double cohesion, double friction, double dilation) {
  return {1e8, 0.3, cohesion, friction * degree, dilation * degree};
}
/// Strains of a step here are about 1e-3: half the strength is gone after a few.
template <class Model>
Model softened(Model soil, SofteningLaw law, double dilation_limit = 1.0) {
  soil.residual_cohesion = 0.2 * soil.cohesion;
  soil.residual_friction_angle = 0.5 * soil.friction_angle;
  soil.softening = law;
  soil.softening_slip = 0.005;
  soil.dilation_limit = dilation_limit;
  return soil;
}
MohrCoulomb cut_off(MohrCoulomb soil, double tensile_strength) {
  soil.tensile_strength = tensile_strength;
  return soil;
}
const std::vector<Material>& materials() {
  using enum SofteningLaw;
  static const std::vector<Material> all{
      {"elastic", LinearElastic{1e8, 0.3}},
      {"psi_0", cone_soil(1e4, 20, 0)},
      {"psi_9", cone_soil(1e4, 20, 9)},
      {"associated", cone_soil(5e3, 33, 33)},
      {"phi_0", cone_soil(2e4, 0, 0)},
      {"c_0", cone_soil(0, 33, 0)},
      {"no_strength", cone_soil(0, 0, 0)},
      {"softening", softened(cone_soil(1e4, 20, 9), exponential)},
      {"softening_linear", softened(cone_soil(1e4, 20, 9), linear, 0.0)},
      {"coulomb_psi_0", coulomb_soil(1e4, 20, 0)},
      {"coulomb_psi_9", coulomb_soil(1e4, 20, 9)},
      {"coulomb_associated", coulomb_soil(5e3, 33, 33)},
      {"coulomb_phi_0", coulomb_soil(2e4, 0, 0)},
      {"coulomb_c_0", coulomb_soil(0, 33, 0)},
      {"coulomb_cut_off", cut_off(coulomb_soil(1e4, 20, 9), 5e3)},
      {"coulomb_phi_0_cut_off", cut_off(coulomb_soil(2e4, 0, 0), 5e3)},
      {"coulomb_no_tension", cut_off(coulomb_soil(1e4, 30, 0), 0.0)},
      {"coulomb_softening", softened(coulomb_soil(1e4, 20, 9), exponential)},
      {"coulomb_softening_linear", softened(coulomb_soil(1e4, 20, 9), linear, 0.0)}};
  return all;
}

/// Random states at, in and beyond the surface, and steps large enough to reach the apex.
class States {
 public:
  States(int dimension, unsigned seed) : dimension_(dimension), engine_(seed) {}

  ReferencePoint point() {
    ReferencePoint p;
    for (int a = 0; a < dimension_; ++a) {
      p.position[a] = unit();
      p.velocity[a] = unit();
      p.previous_velocity[a] = unit();
    }
    p.density = 2000.0 + 100.0 * unit();
    p.previous_density = p.density + unit();
    p.stress = tensor(-3e4 + 6e4 * unit(), 2e4);
    p.previous_stress = tensor(-3e4 + 6e4 * unit(), 2e4);
    return p;
  }
  ReferencePointRates rates() {
    ReferencePointRates r;
    const double size = std::pow(10.0, 2.0 * unit());
    for (int a = 0; a < dimension_; ++a) {
      r.acceleration[a] = 10.0 * unit();
      for (int b = 0; b < dimension_; ++b) r.velocity_gradient[a][b] = size * unit();
    }
    r.moment = tensor(0.8, 0.2);
    if (unit() > 0.7) r.moment = tensor(0.1, 0.1);  // not usable
    r.diffusion_rate = tensor(0.0, 1e6);
    r.diffusion_slope = 100.0 * unit();
    r.density_rate = 1e3 * unit();
    return r;
  }

 private:
  double unit() { return distribution_(engine_); }
  ReferenceMatrix tensor(double mean, double spread) {
    ReferenceMatrix m{};
    for (int c = 0; c < (dimension_ == 2 ? 4 : 6); ++c) {
      m[row[c]][column[c]] = m[column[c]][row[c]] = (c <= zz ? mean : 0.0) + spread * unit();
    }
    return m;
  }

  int dimension_;
  std::mt19937 engine_;
  std::uniform_real_distribution<double> distribution_{-1.0, 1.0};
};

StressPassConstants constants_for(const Material& material) {
  StressPassConstants c{};
  c.model = model_named(material.model)->prepare(material.parameters, {1.0, 0.25, 2000.0});
  c.reference_density = 2000.0;
  c.density_minimum = 1950.0;  // near enough that the bounds act
  c.density_maximum = 2060.0;
  c.leap = 4e-5;
  c.plastic_share = 0.5;
  c.smoothing_length = 0.3;
  c.gravity[0] = 0.5;
  c.gravity[1] = -9.8;
  c.k0 = 0.6;
  return c;
}

/// Largest stress along the way: what the rounding of a step is measured by.
double stress_scale(const StressPassConstants& c, const ReferencePoint& p,
                    const ReferencePointRates& r) {
  double stress = 1.0, gradient = 0.0;
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      stress = std::fmax(stress,
                         std::fmax(std::fabs(p.stress[a][b]), std::fabs(p.previous_stress[a][b])));
      gradient = std::fmax(gradient, std::fabs(r.velocity_gradient[a][b]));
    }
  }
  // A moment just above the smallest determinant multiplies the gradient by up to 10, in 3D 100.
  // 3 c cot phi of the materials here, the mean stress at an apex, is below 1e5.
  return stress + 300.0 * c.leap * gradient * bulk_modulus + 1e5;
}

/// Two points agree: 1e-12 of the scale covers some hundred roundings a step and their growth over
/// the steps.
void expect_same(const ParticleView& v, std::size_t k, const ReferencePoint& p, double scale,
                 double strain, const StressPassConstants& c, int dimension) {
  const double tolerance = 1e-12;
  for (int s = 0; s < (dimension == 2 ? 4 : 6); ++s) {
    ASSERT_NEAR(v.stress[s][k], p.stress[row[s]][column[s]], tolerance * scale)
        << "stress component " << s;
  }
  ASSERT_NEAR(v.density[k], p.density, tolerance * p.density);
  ASSERT_NEAR(v.history[0][k], p.history[0], tolerance * (strain + scale / shear_modulus));
  const double work = scale * (strain + scale / shear_modulus) / p.density;
  ASSERT_NEAR(v.stress_work[k], p.stress_work, tolerance * work);
  ASSERT_NEAR(v.plastic_work[k], p.plastic_work, tolerance * work);
  ASSERT_NEAR(v.diffusion_work[k], p.diffusion_work, tolerance * work);
  if (c.diffusion_cap > 0.0) {
    ASSERT_NEAR(v.diffusivity[k], p.diffusivity, tolerance * p.diffusivity);
  }
}

class StressPassTest : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  const Material& material_ = materials()[static_cast<std::size_t>(std::get<0>(GetParam()))];
  const int dimension_ = std::get<1>(GetParam());

  const ModelInfo& info() const { return *model_named(material_.model); }

  /// Runs `steps` steps of pass and reference for every instruction set and combination of options.
  template <class Step, class Reference>
  void compare(int steps, Step step, Reference reference) {
    for (const Isa isa : available_isas()) {
      for (int options = 0; options < 8; ++options) {
        StressPassConstants c = constants_for(material_);
        c.hughes_winget = (options & 1) != 0;
        c.gradient_correction = (options & 2) != 0;
        if ((options & 4) != 0) {
          c.diffusion_cap = 0.1;
          c.diffusion_shear_gate = 20.0;
        }
        SCOPED_TRACE(std::string(isa_name(isa)) + " options " + std::to_string(options));
        States states(dimension_, 100u + static_cast<unsigned>(options));
        Arrays arrays(dimension_);
        std::vector<ReferencePoint> points(count);
        std::vector<double> scale(count, 0.0), strain(count, 0.0);
        for (std::size_t k = 0; k < count; ++k) {
          points[k] = states.point();
          arrays.store(k, points[k]);
        }
        for (int n = 0; n < steps; ++n) {
          std::uint64_t bounded = 0;
          for (std::size_t k = 0; k < count; ++k) {
            const ReferencePointRates rates = states.rates();
            arrays.store(k, rates);
            scale[k] = std::fmax(scale[k], stress_scale(c, points[k], rates));
            strain[k] += 30.0 * c.leap * std::fabs(rates.velocity_gradient[0][0]);
            bounded += reference(rates, c, n, points[k]);
          }
          ASSERT_EQ(step(kernels_of(isa), arrays.view, c, n), bounded) << "step " << n;
          for (std::size_t k = 0; k < count; ++k) {
            expect_same(arrays.view, k, points[k], scale[k], strain[k], c, dimension_);
            for (int a = 0; a < dimension_; ++a) {
              ASSERT_NEAR(arrays.view.position[a][k], points[k].position[a], 1e-14);
              ASSERT_NEAR(arrays.view.velocity[a][k], points[k].velocity[a], 1e-13);
            }
            ASSERT_FALSE(HasFatalFailure()) << "particle " << k << " step " << n;
          }
        }
      }
    }
  }
};

TEST_P(StressPassTest, VerletAgreesWithTheReferenceOverSteps) {
  // A forward step, leaps, another forward step with half the time, and leaps again.
  const auto verlet = [](int n) { return VerletConstants{2e-5, n != 0 && n != 4, 30.0}; };
  const auto timed = [](StressPassConstants c, int n) {
    if (n == 0 || n == 4) {
      c.leap *= 0.5;
      c.plastic_share = 1.0;
    }
    return c;
  };
  compare(
      8,
      [&](const KernelTable& table, const ParticleView& view, const StressPassConstants& c, int n) {
        return table.passes_of(info()).verlet[static_cast<std::size_t>(dimension_ - 2)](
            view, timed(c, n), verlet(n), 0, count);
      },
      [&](const ReferencePointRates& rates, const StressPassConstants& c, int n,
          ReferencePoint& point) {
        return advance_verlet_reference(rates, timed(c, n), verlet(n), dimension_,
                                        reference_model(material_.model, c.model), point);
      });
}

TEST_P(StressPassTest, StressPassAgreesWithTheReferenceOverSteps) {
  compare(
      5,
      [&](const KernelTable& table, const ParticleView& view, const StressPassConstants& c, int) {
        return table.passes_of(info()).stress[static_cast<std::size_t>(dimension_ - 2)](view, c, 0,
                                                                                        count);
      },
      [&](const ReferencePointRates& rates, const StressPassConstants& c, int,
          ReferencePoint& point) {
        return advance_stress_reference(rates, c, dimension_,
                                        reference_model(material_.model, c.model), point);
      });
}

std::string name_of(const testing::TestParamInfo<std::tuple<int, int>>& p) {
  const auto [material, dimension] = p.param;
  return materials()[static_cast<std::size_t>(material)].label + "_" + std::to_string(dimension) +
         "D";
}

INSTANTIATE_TEST_SUITE_P(AllMaterials, StressPassTest,
                         testing::Combine(testing::Range(0, static_cast<int>(materials().size())),
                                          testing::Values(2, 3)),
                         name_of);

TEST(StressPassRangeTest, TouchesOnlyItsRange) {
  for (const Isa isa : available_isas()) {
    StressPassConstants c = constants_for(materials()[2]);
    States states(3, 9);
    Arrays arrays(3);
    for (std::size_t k = 0; k < count; ++k) {
      arrays.store(k, states.point());
      arrays.store(k, states.rates());
    }
    const std::vector<double> before(arrays.view.stress[xx], arrays.view.stress[xx] + count);
    kernels_of(isa).passes_of(*model_named("drucker_prager")).stress[1](arrays.view, c, 16, 32);
    for (std::size_t k = 0; k < count; ++k) {
      EXPECT_EQ(arrays.view.stress[xx][k] == before[k], k < 16 || k >= 32)
          << isa_name(isa) << " particle " << k;
    }
  }
}

TEST(StressPassRangeTest, ReachesConeAndApexInTheRandomStates) {
  // The comparison above is worth something only if its states go everywhere.
  int elastic = 0, cone = 0, apex = 0;
  StressPassConstants c = constants_for(materials()[2]);
  const ConeConstants surface = unpacked<DruckerPrager::Constants>(c.model).cone;
  States states(3, 100);
  for (int k = 0; k < 2000; ++k) {
    ReferencePoint p = states.point();
    advance_stress_reference(states.rates(), c, 3, reference_model("drucker_prager", c.model), p);
    const double i1 = p.stress[0][0] + p.stress[1][1] + p.stress[2][2];
    const bool at_apex = std::fabs(i1 - surface.k_c / surface.alpha_phi) < 1e-6 * surface.k_c;
    elastic += p.history[0] == 0.0;
    apex += at_apex;
    cone += p.history[0] > 0.0 && !at_apex;
  }
  EXPECT_GT(elastic, 100);
  EXPECT_GT(cone, 100);
  EXPECT_GT(apex, 100);
}

}  // namespace
}  // namespace scarp::test
