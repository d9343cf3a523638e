// SPDX-License-Identifier: BSD-3-Clause
/// Positive part of a stress against eigenvectors, and the polynomials for F^n.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

#include "engine/scene/tension_factor_fit.hpp"
#include "kernels/pair/artificial_stress.hpp"
#include "kernels/pair/artificial_stress_tensor.hpp"
#include "kernels/pair/pair_sweep_reference.hpp"
#include "kernels/smoothing/list.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

double largest_component(const SymTensor<double>& s) {
  return std::fmax(std::fmax(std::fmax(std::fabs(s.xx), std::fabs(s.yy)), std::fabs(s.zz)),
                   std::fmax(std::fmax(std::fabs(s.xy), std::fabs(s.yz)), std::fabs(s.zx)));
}

/// diag(values) turned by three angles.
SymTensor<double> turned(const double (&values)[3], double a, double b, double c) {
  const auto about = [](int axis, double angle) {
    Tensor<double> q{};
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    q.m[axis][axis] = 1.0;
    q.m[i][i] = q.m[j][j] = std::cos(angle);
    q.m[i][j] = -std::sin(angle);
    q.m[j][i] = std::sin(angle);
    return q;
  };
  const SymTensor<double> s{values[0], values[1], values[2], 0.0, 0.0, 0.0};
  return rotated(rotated(rotated(s, about(2, a)), about(0, b)), about(1, c));
}

void expect_positive_part(const SymTensor<double>& s, int dimension) {
  const std::array<double, 6> expected =
      positive_part_reference({s.xx, s.yy, s.zz, s.xy, s.yz, s.zx}, dimension);
  const SymTensor<double> actual = positive_part(s, dimension);
  const SymTensor<double> difference =
      actual - SymTensor<double>{expected[0], expected[1], expected[2],
                                 expected[3], expected[4], expected[5]};
  // About 30 roundings, divided by the distance of the lone eigenvalue, which is at least a third
  // of the size.
  ASSERT_LE(largest_component(difference), 1e-12 * largest_component(s))
      << dimension << "D, stress " << s.xx << " " << s.yy << " " << s.zz << " " << s.xy << " "
      << s.yz << " " << s.zx;
  if (in_compression(s, dimension)) {
    // A determinant loses the sign of an eigenvalue that is 1e-8 of the largest where another is as
    // small.
    ASSERT_LE(largest_component(actual), 1e-8 * largest_component(s));
  }
}

TEST(PositivePartTest, AgreesWithEigenvectorsForRandomStress) {
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> unit(-1.0, 1.0), exponent(-6.0, 6.0);
  for (int k = 0; k < 50000; ++k) {
    const double scale = std::pow(10.0, exponent(engine)), shift = 2.0 * scale * unit(engine);
    SymTensor<double> s{shift + scale * unit(engine), shift + scale * unit(engine),
                        shift + scale * unit(engine), scale * unit(engine),
                        scale * unit(engine),         scale * unit(engine)};
    expect_positive_part(s, 3);
    s.yz = s.zx = 0.0;
    expect_positive_part(s, 2);
  }
}

TEST(PositivePartTest, AgreesWithEigenvectorsForDegenerateStress) {
  std::mt19937 engine(2);
  std::uniform_real_distribution<double> angle(-3.2, 3.2);
  std::uniform_int_distribution<int> pick(0, 12);
  const double choices[] = {-1.0,  0.0,    1.0,   -1e-4,  1e-4, 1e-8,      -1e-8,
                            1e-12, -1e-12, 1e-16, -1e-16, 0.5,  1.0 + 1e-9};
  for (int k = 0; k < 50000; ++k) {
    const double values[3] = {1e5 * choices[pick(engine)], 1e5 * choices[pick(engine)],
                              1e5 * choices[pick(engine)]};
    const bool axes = k % 4 == 0;
    expect_positive_part(axes ? turned(values, 0.0, 0.0, 0.0)
                              : turned(values, angle(engine), angle(engine), angle(engine)),
                         3);
    SymTensor<double> plane = turned(values, angle(engine), 0.0, 0.0);
    plane.yz = plane.zx = 0.0;
    expect_positive_part(plane, 2);
  }
}

TEST(PositivePartTest, SplitsPlainCases) {
  const SymTensor<double> s{-3.0, 2.0, 5.0, 0.0, 0.0, 0.0};
  const SymTensor<double> space = positive_part(s, 3), plane = positive_part(s, 2);
  EXPECT_NEAR(space.xx, 0.0, 1e-15);
  EXPECT_NEAR(space.yy, 2.0, 1e-14);
  EXPECT_NEAR(space.zz, 5.0, 1e-14);
  EXPECT_NEAR(plane.yy, 2.0, 1e-15);
  EXPECT_EQ(plane.zz, 0.0);  // out-of-plane tension does not count in 2D (m = 2 in Eq. 27)
}

TEST(PositivePartTest, KnowsCompression) {
  EXPECT_TRUE(in_compression({-1.0, -2.0, -3.0, 0.5, 0.3, 0.2}, 3));
  EXPECT_TRUE(in_compression({0.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 3));
  EXPECT_TRUE(in_compression({0.0, -1.0, 0.0, 0.0, 0.0, 0.0}, 3));
  EXPECT_TRUE(in_compression({-1.0, -1.0, 4.0, 0.5, 0.0, 0.0}, 2));
  EXPECT_FALSE(in_compression({-1.0, -1.0, 4.0, 0.5, 0.0, 0.0}, 3));
  EXPECT_FALSE(in_compression({-1.0, -1.0, -1.0, 1.1, 0.0, 0.0}, 2));
  EXPECT_FALSE(in_compression({-1.0, -1.0, -1.0, 0.0, 1.1, 0.0}, 3));
  EXPECT_FALSE(in_compression({-1.0, -1.0, -1.0, 0.0, 0.0, 1.1}, 3));
  EXPECT_FALSE(in_compression({-1.0, -1.0, -1.0, 0.9, 0.9, 0.9}, 3));  // all 2 x 2 minors positive
}

/// Error of the factor as the sweep evaluates it, over the greater of F^n and F^n(dx) = 1.
double fit_error(const SmoothingForm& form, double spacing_ratio, double exponent) {
  const TensionFactorFit fit = fit_tension_factor(form, spacing_ratio, exponent);
  using B = Batch<double, xsimd::default_arch>;
  double worst = 0.0;
  for (int k = 0; k <= 4000; ++k) {
    const double q = 0.0005 * k;
    const double exact = std::pow(form.shape(q) / form.shape(spacing_ratio), exponent);
    alignas(16) double fitted[2];
    tension_factor(TruncatedPowers(B(q)), fit.factor).store_aligned(fitted);
    worst = std::fmax(worst, std::fabs(fitted[0] - exact) / std::fmax(1.0, exact));
  }
  // The fit looks between its points no closer than at them.
  EXPECT_LT(worst, 1.5 * fit.error + 1e-12);
  return worst;
}

TEST(TensionFactorTest, FitIsCloseToThePower) {
  // The bounds the sweep tests rely on; n = 2.55 at h = 1.2 dx.
  EXPECT_LT(fit_error(yang_liu, 1.0 / 1.2, 2.55), 2e-7);
  EXPECT_LT(fit_error(cubic_spline, 1.0 / 1.2, 2.55), 7e-6);
  EXPECT_LT(fit_error(wendland_c2, 1.0 / 1.2, 2.55), 1.5e-4);
  // Exact where F^n is itself such a sum of powers.
  for (const SmoothingForm& form : smoothing_functions) {
    EXPECT_LT(fit_error(form, 1.0 / 1.2, 1.0), 1e-12) << form.name;
  }
  EXPECT_LT(fit_error(yang_liu, 1.0 / 1.2, 2.0), 1e-12);
  EXPECT_LT(fit_error(cubic_spline, 1.0 / 1.2, 2.0), 1e-12);
  for (const SmoothingForm& form : smoothing_functions) {
    for (const double spacing_ratio : {1.0, 1.0 / 1.2, 1.0 / 1.5}) {
      for (double exponent = 1.0; exponent <= 4.0; exponent += 0.25) {
        EXPECT_LT(fit_error(form, spacing_ratio, exponent), 6e-3)
            << form.name << " n = " << exponent << " dx/h = " << spacing_ratio;
      }
    }
  }
  // The ends that SCENE.md names, and exponents beyond them.
  EXPECT_LT(fit_error(yang_liu, 1.0 / 1.2, 0.4), 0.01);
  EXPECT_LT(fit_error(yang_liu, 1.0 / 1.2, 7.0), 0.01);
  EXPECT_GT(fit_tension_factor(yang_liu, 1.0 / 1.2, 0.2).error, 0.01);
  EXPECT_GT(fit_tension_factor(yang_liu, 1.0 / 1.2, 8.0).error, 0.01);
}

TEST(TensionFactorTest, SinglePrecisionAddsLittle) {
  // Terms of alternating sign cancel: 24 bits of the largest, more of them the steeper F^n.
  for (const auto& [exponent, bound] : {std::pair{2.55, 2e-6}, std::pair{7.0, 1e-3}}) {
    const TensionFactorView<double> wide = fit_tension_factor(yang_liu, 1.0 / 1.2, exponent).factor;
    TensionFactorView<float> narrow{};
    const auto cast = [](double value) { return static_cast<float>(value); };
    std::ranges::transform(wide.outer, narrow.outer, cast);
    std::ranges::transform(wide.inner, narrow.inner, cast);
    for (int k = 0; k <= 4000; ++k) {
      const double q = 0.0005 * k;
      alignas(16) double exact[2];
      alignas(16) float got[4];
      tension_factor(TruncatedPowers(Batch<double, xsimd::default_arch>(q)), wide)
          .store_aligned(exact);
      tension_factor(TruncatedPowers(Batch<float, xsimd::default_arch>(static_cast<float>(q))),
                     narrow)
          .store_aligned(got);
      const double scale =
          std::fmax(1.0, std::pow(yang_liu.shape(q) / yang_liu.shape(1.0 / 1.2), exponent));
      ASSERT_NEAR(static_cast<double>(got[0]), exact[0], bound * scale) << "q = " << q;
    }
  }
}

}  // namespace
}  // namespace scarp::test
