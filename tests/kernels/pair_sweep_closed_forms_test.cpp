// SPDX-License-Identifier: BSD-3-Clause
/// Closed forms of the pair sweeps that need no reference.
#include <cmath>

#include "kernels/constitutive/stress_pass.hpp"
#include "tests/kernels/pair_sweep_cases.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

/// Velocity gradient and moment of particle i as a sweep left them.
struct GradientAndMoment {
  Tensor<double> gradient{};
  SymTensor<double> moment{0.0, 0.0, 1.0, 0.0, 0.0, 0.0};

  int dimension;

  GradientAndMoment(SweepOutput& out, std::size_t i, int dim) : dimension(dim) {
    for (int a = 0; a < dimension; ++a) {
      for (int b = 0; b < dimension; ++b) gradient.m[a][b] = out.field(1 + 3 * a + b)[i];
    }
    moment.xx = out.field(10)[i];
    moment.yy = out.field(11)[i];
    moment.xy = out.field(13)[i];
    if (dimension == 2) return;
    moment.zz = out.field(12)[i];
    moment.yz = out.field(14)[i];
    moment.zx = out.field(15)[i];
  }
  double determinant() const {
    const SymTensor<double>& m = moment;
    return m.xx * (m.yy * m.zz - m.yz * m.yz) - m.xy * (m.xy * m.zz - m.yz * m.zx) +
           m.zx * (m.xy * m.yz - m.yy * m.zx);
  }
  double smallest() const {
    return dimension == 2 ? smallest_moment_determinant<2> : smallest_moment_determinant<3>;
  }
  Tensor<double> corrected() const {
    return dimension == 2 ? corrected_gradient<2>(gradient, moment)
                          : corrected_gradient<3>(gradient, moment);
  }
};

class PairSweepClosedFormTest : public testing::TestWithParam<SweepCase> {
 protected:
  const int dimension_ = std::get<1>(GetParam());
  const ReferenceSettings settings_ = settings_for(std::get<0>(GetParam()), dimension_);
};

TEST_P(PairSweepClosedFormTest, LinearVelocityFieldHasItsGradientExactlyAfterCorrection) {
  BlockOptions options = block_for(dimension_);
  options.walls = false;
  ReferenceParticles p = random_block(options, 11);
  double field[3][3] = {{0.3, -1.2, 0.8}, {2.1, -0.4, 0.5}, {-0.7, 0.6, 0.9}};
  for (std::size_t i = 0; i < p.size(); ++i) {
    for (int a = 0; a < dimension_; ++a) {
      p.velocity[i][a] = 5.0;
      for (int b = 0; b < dimension_; ++b) p.velocity[i][a] += field[a][b] * p.position[i][b];
    }
  }
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    const PackedParticles packed(p, settings_, table.cluster_size);
    PairSweepView<double> view = packed.sweep_view(false);
    SweepOutput out(packed.slots());
    out.attach(view);
    table.sweep_for({dimension_, {Term::velocity_gradient, Term::moment}})(view, 0,
                                                                           packed.soil_clusters());
    int corrected = 0;
    for (std::size_t i = 0; i < p.soil_count; ++i) {
      const GradientAndMoment at(out, i, dimension_);
      const Tensor<double> used = at.corrected();
      const bool usable = at.determinant() >= at.smallest();
      corrected += usable;
      for (int a = 0; a < dimension_; ++a) {
        for (int b = 0; b < dimension_; ++b) {
          // Velocities up to 12, gradients of 1/h: eps x 100 terms x 12/h, over a moment of at
          // least 0.1.
          const double expected = usable ? field[a][b] : at.gradient.m[a][b];
          ASSERT_NEAR(used.m[a][b], expected, 1e-11) << table.name << " particle " << i;
        }
      }
    }
    // Faces included: only corners, in 3D edges, and the stray particle may fall below the
    // determinant.
    ASSERT_GE(corrected + (dimension_ == 2 ? 5 : 57), static_cast<int>(p.soil_count));
  }
}

TEST_P(PairSweepClosedFormTest, RigidRotationHasNoStrainAfterCorrection) {
  BlockOptions options = block_for(dimension_);
  options.walls = false;
  ReferenceParticles p = random_block(options, 13);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const auto& x = p.position[i];
    p.velocity[i] = dimension_ == 2
                        ? std::array<double, 3>{-2.0 * x[1], 2.0 * x[0], 0.0}
                        : std::array<double, 3>{0.5 * x[2] - 2.0 * x[1], 2.0 * x[0] + 1.5 * x[2],
                                                -0.5 * x[0] - 1.5 * x[1]};
  }
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    const PackedParticles packed(p, settings_, table.cluster_size);
    PairSweepView<double> view = packed.sweep_view(false);
    SweepOutput out(packed.slots());
    out.attach(view);
    table.sweep_for({dimension_, {Term::velocity_gradient, Term::moment}})(view, 0,
                                                                           packed.soil_clusters());
    double plain = 0.0;
    for (std::size_t i = 0; i < p.soil_count; ++i) {
      const GradientAndMoment at(out, i, dimension_);
      if (at.determinant() < at.smallest()) continue;
      const Tensor<double> used = at.corrected();
      const SymTensor<double> before = symmetric_part(at.gradient), strain = symmetric_part(used);
      plain = std::fmax(plain, std::sqrt(contract(before, before)));
      ASSERT_LT(std::sqrt(contract(strain, strain)), 1e-11) << table.name << " particle " << i;
      ASSERT_NEAR(used.m[1][0], 2.0, 1e-11);
    }
    ASSERT_GT(plain, 0.1);  // the plain gradient strains a body in rigid rotation: the test bites
  }
}

TEST_P(PairSweepClosedFormTest, FreeBlockKeepsItsMomentum) {
  BlockOptions options = block_for(dimension_);
  options.walls = false;
  const ReferenceParticles p = random_block(options, 17);
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    const PackedParticles packed(p, settings_, table.cluster_size);
    PairSweepView<double> view = packed.sweep_view(true);
    SweepOutput out(packed.slots());
    out.attach(view);
    table.sweep_for({dimension_, {Term::momentum, Term::viscosity, Term::artificial_stress}})(
        view, 0, packed.soil_clusters());
    for (int a = 0; a < dimension_; ++a) {
      double sum = 0.0, magnitude = 0.0;
      for (std::size_t i = 0; i < p.soil_count; ++i) {
        const double force =
            p.volume[i] * p.density[i] * out.field(SweepOutput::acceleration + a)[i];
        sum += force;
        magnitude += std::fabs(force);
      }
      ASSERT_GT(magnitude, 0.0);
      // 64 eps a term as above; the forces themselves are a sum of about ten times larger terms.
      ASSERT_NEAR(sum, 0.0, 640.0 * epsilon * magnitude) << table.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllFunctions, PairSweepClosedFormTest, all_sweep_cases(), name_of_case);

}  // namespace
}  // namespace scarp::test
