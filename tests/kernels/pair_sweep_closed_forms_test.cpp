// SPDX-License-Identifier: BSD-3-Clause
/// Closed forms of the pair sweeps that need no reference.
#include <cmath>
#include <vector>

#include "kernels/constitutive/stress_pass.hpp"
#include "kernels/pair/force_correction.hpp"
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
  Tensor<double> corrected() const { return conjugate_gradient(gradient, moment); }
};

constexpr TermSet corrected_terms{Term::velocity_gradient, Term::moment, Term::wall_gradient};

class PairSweepClosedFormTest : public testing::TestWithParam<SweepCase> {
 protected:
  const int dimension_ = std::get<1>(GetParam());
  const ReferenceSettings settings_ = settings_for(std::get<0>(GetParam()), dimension_);

  /// Whose moment is the sum itself, without a share of the identity.
  std::vector<bool> exact(const ReferenceParticles& p) const {
    ReferenceSettings corrected = settings_;
    corrected.corrected = true;
    std::vector<bool> all;
    for (const ReferenceRate& rate : pair_sweep_reference(p, corrected))
      all.push_back(rate.identity_share == 0.0);
    return all;
  }
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
  const std::vector<bool> usable = exact(p);
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    const PackedParticles packed(p, settings_, table.cluster_size);
    PairSweepView<double> view = packed.sweep_view(false);
    SweepOutput out(packed.slots());
    out.attach(view);
    table.sweep_for({dimension_, corrected_terms})(view, 0, packed.soil_clusters());
    int corrected = 0;
    for (std::size_t i = 0; i < p.soil_count; ++i) {
      const GradientAndMoment at(out, i, dimension_);
      const Tensor<double> used = at.corrected();
      corrected += usable[i];
      if (!usable[i]) continue;
      for (int a = 0; a < dimension_; ++a) {
        for (int b = 0; b < dimension_; ++b) {
          // Velocities up to 12, gradients of 1/h: eps x 100 terms x 12/h, over a moment of at
          // least 0.1.
          ASSERT_NEAR(used.m[a][b], field[a][b], 1e-11) << table.name << " particle " << i;
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
  const std::vector<bool> usable = exact(p);
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    const PackedParticles packed(p, settings_, table.cluster_size);
    PairSweepView<double> view = packed.sweep_view(false);
    SweepOutput out(packed.slots());
    out.attach(view);
    table.sweep_for({dimension_, corrected_terms})(view, 0, packed.soil_clusters());
    double plain = 0.0;
    for (std::size_t i = 0; i < p.soil_count; ++i) {
      const GradientAndMoment at(out, i, dimension_);
      if (!usable[i]) continue;
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

/// T = sigma B of every particle with the moment that the sweep of gradients stored, and what the
/// dummies take from and give to the soil.
void correct(ReferenceParticles& p, const ReferenceSettings& s, const KernelTable& table) {
  const int d = s.dimension;
  for (int pass = 0; pass < 2; ++pass) {
    const auto dummies = wall_sweep_reference(p, s);
    for (std::size_t w = 0; w < p.wall_count; ++w) {
      for (std::size_t c = 0; c < 9; ++c) {
        p.wall_gradient[p.soil_count + w][c] =
            p.volume[p.soil_count + w] * dummies[w].gradient[c].value;
        p.force_stress[p.soil_count + w][c] = dummies[w].force_stress[c].value;
      }
    }
    if (pass == 1) return;
    const PackedParticles packed(p, s, table.cluster_size, Packing::corrected_gradient);
    PairSweepView<double> view = packed.sweep_view(false);
    SweepOutput out(packed.slots());
    out.attach(view);
    table.sweep_for({d, corrected_terms})(view, 0, packed.soil_clusters());
    for (std::size_t i = 0; i < p.soil_count; ++i) {
      const GradientAndMoment at(out, i, d);
      const auto& a = p.stress[i];
      const Tensor<double> t = corrected_stress(
          SymTensor<double>{a[0], a[1], a[2], a[3], a[4], a[5]}, inverse_of(at.moment));
      for (std::size_t c = 0; c < 9; ++c) p.force_stress[i][c] = t.m[c / 3][c % 3];
    }
  }
}

TEST_P(PairSweepClosedFormTest, TheCorrectedForceTakesThePowerOfTheStressOnTheCorrectedGradient) {
  // sum m a.v = -sum V sigma : L for any stress and any velocity, with walls at rest too, whose own
  // strain is the transpose of the average by which they take the stress. No image may be near: of
  // the pairs with images only one side is summed.
  for (const bool walls : {false, true}) {
    BlockOptions options = block_for(dimension_);
    options.walls = walls;
    ReferenceParticles p = random_block(options, 19);
    while (p.size() > p.soil_count + p.wall_count) {
      for (auto* vectors : {&p.position, &p.velocity}) vectors->pop_back();
      for (auto* scalars : {&p.density, &p.volume, &p.sound_speed, &p.diffusivity})
        scalars->pop_back();
      for (auto* tensors : {&p.stress, &p.artificial_stress}) tensors->pop_back();
      for (auto* full : {&p.force_stress, &p.wall_gradient}) full->pop_back();
      p.face.pop_back();
    }
    for (std::size_t k = p.soil_count; k < p.size(); ++k) p.velocity[k] = {};
    ReferenceSettings s = settings_;
    s.viscosity_alpha = s.viscosity_beta = s.hourglass_viscosity = 0.0;
    s.gravity = {};
    for (const Isa isa : available_isas()) {
      const KernelTable& table = kernels_of(isa);
      correct(p, s, table);
      const auto swept = [&](TermSet terms) {
        const PackedParticles packed(p, s, table.cluster_size, packing_for(terms));
        PairSweepView<double> view = packed.sweep_view(false);
        SweepOutput out(packed.slots());
        out.attach(view);
        table.sweep_for({dimension_, terms})(view, 0, packed.soil_clusters());
        return out;
      };
      SweepOutput gradients = swept(corrected_terms),
                  forces = swept({Term::momentum, Term::force_correction, Term::viscosity});
      double power = 0.0, magnitude = 0.0;
      for (std::size_t i = 0; i < p.soil_count; ++i) {
        const Tensor<double> l = GradientAndMoment(gradients, i, dimension_).corrected();
        const auto& a = p.stress[i];
        const double stress[3][3] = {{a[0], a[3], a[5]}, {a[3], a[1], a[4]}, {a[5], a[4], a[2]}};
        for (int c = 0; c < dimension_; ++c) {
          const double part = p.volume[i] * p.density[i] * p.velocity[i][c] *
                              forces.field(SweepOutput::acceleration + c)[i];
          power += part;
          magnitude += std::fabs(part);
          for (int b = 0; b < dimension_; ++b) power += p.volume[i] * stress[c][b] * l.m[c][b];
        }
      }
      ASSERT_GT(magnitude, 0.0);
      // Rounding as of the momentum of a free block.
      EXPECT_NEAR(power, 0.0, 640.0 * epsilon * magnitude)
          << table.name << (walls ? " with walls" : "");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllFunctions, PairSweepClosedFormTest, all_sweep_cases(), name_of_case);

}  // namespace
}  // namespace scarp::test
