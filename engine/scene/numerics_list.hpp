// SPDX-License-Identifier: BSD-3-Clause
/// The one table of the numerics: reader, presets, checks, scene text, results and SCENE.md follow
/// from it.
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "engine/scene/scene.hpp"

namespace scarp {

/// One member of `Numerics` under its key. Every value fits a double: a truth as 0 or 1, a choice
/// as the number of its word, 0 where a value may be left out.
struct NumericsRow {
  enum class Kind { number, integer, truth, choice };

  std::string_view key;
  Kind kind;
  std::string_view words;  ///< of a choice, in order, with | between; of a number the word for 0
  std::string_view unit;
  double minimum, maximum;
  double paper;  ///< value of the preset "paper"; that of "modern" is the default of the member
  std::string_view text;
  double (*get)(const Numerics&);
  void (*set)(Numerics&, double);

  /// The value as a scene has it: true, 40, 0.3, cubic_spline, auto.
  std::string written(const Numerics& numerics) const;
};

namespace detail {

template <auto Member>
using MemberOf = std::remove_cvref_t<decltype(std::declval<Numerics>().*Member)>;

template <class T>
constexpr NumericsRow::Kind kind_of() {
  if (std::is_same_v<T, bool>) return NumericsRow::Kind::truth;
  if (std::is_same_v<T, int>) return NumericsRow::Kind::integer;
  return std::is_enum<T>::value ? NumericsRow::Kind::choice : NumericsRow::Kind::number;
}

template <class T>
inline constexpr bool is_optional = std::is_same_v<T, std::optional<double>>;

template <auto Member>
double get(const Numerics& numerics) {
  if constexpr (is_optional<MemberOf<Member>>) {
    return (numerics.*Member).value_or(0.0);
  } else {
    return static_cast<double>(numerics.*Member);
  }
}
template <auto Member>
void set(Numerics& numerics, double value) {
  using T = MemberOf<Member>;
  if constexpr (is_optional<T>) {
    numerics.*Member = value != 0.0 ? T(value) : T();
  } else if constexpr (std::is_enum_v<T>) {
    numerics.*Member = static_cast<T>(static_cast<int>(value));
  } else {
    numerics.*Member = static_cast<T>(value);
  }
}

struct Bounds {
  double minimum, maximum;
};

template <auto Member>
constexpr NumericsRow number(std::string_view key, Bounds bounds, double paper,
                             std::string_view unit, std::string_view text,
                             std::string_view word_for_0 = {}) {
  return {key,
          kind_of<MemberOf<Member>>(),
          word_for_0,
          unit,
          bounds.minimum,
          bounds.maximum,
          paper,
          text,
          get<Member>,
          set<Member>};
}
template <auto Member>
constexpr NumericsRow truth(std::string_view key, bool paper, std::string_view text) {
  return number<Member>(key, {0.0, 1.0}, paper ? 1.0 : 0.0, "-", text);
}
template <auto Member>
constexpr NumericsRow choice(std::string_view key, MemberOf<Member> paper, std::string_view text) {
  constexpr std::string_view all = words<MemberOf<Member>>;
  const auto last = static_cast<double>(std::count(all.begin(), all.end(), '|'));
  return number<Member>(key, {0.0, last}, static_cast<double>(paper), "-", text, all);
}

}  // namespace detail

inline constexpr NumericsRow numerics_list[] = {
    detail::choice<&Numerics::smoothing>(
        "smoothing", SmoothingFunction::yang_liu,
        "smoothing function W; `\"auto\"`: the cubic spline in 2D, Yang and "
        "Liu's in 3D"),
    detail::number<&Numerics::smoothing_ratio>("smoothing_ratio", {0.8, 3.0}, 1.2, "-",
                                               "h/dx; `\"auto\"` and 0: 1.2 in 2D, 1.3 in 3D, "
                                               "whatever `smoothing` is",
                                               "auto"),
    detail::truth<&Numerics::lattice_normalisation>(
        "lattice_normalisation", false, "divide grad W by the moment of the undisturbed lattice"),
    detail::truth<&Numerics::gradient_correction>(
        "gradient_correction", false,
        "correct the velocity gradient, take the density rate from it"),
    detail::truth<&Numerics::force_correction>(
        "force_correction", false,
        "force conjugate to the corrected gradient, rough walls led by their stress; acts with "
        "`gradient_correction`"),
    detail::truth<&Numerics::relaxed_packing>(
        "relaxed_packing", false, "pack the soil anew beside walls that the lattice does not meet"),
    detail::choice<&Numerics::stress_rotation>("stress_rotation", StressRotation::jaumann,
                                               "rotation of the stress with the soil"),
    detail::number<&Numerics::viscosity_alpha>("viscosity_alpha", {0.0, 100.0}, 0.1, "-",
                                               "alpha of the artificial viscosity, Eq. 26"),
    detail::number<&Numerics::viscosity_beta>(
        "viscosity_beta", {0.0, 100.0}, 0.0, "-",
        "beta of the artificial viscosity, Eq. 26; 2 for impacts"),
    detail::number<&Numerics::hourglass_viscosity>(
        "hourglass_viscosity", {0.0, 100.0}, 0.0, "-",
        "viscosity that damps what the velocity gradient does not see; 0 leaves it out; acts with "
        "`force_correction`"),
    detail::number<&Numerics::artificial_stress>("artificial_stress", {0.0, 10.0}, 0.3, "-",
                                                 "epsilon of Eq. 27; 0 leaves the term out"),
    detail::number<&Numerics::artificial_stress_exponent>(
        "artificial_stress_exponent", {0.0, 20.0}, 2.55, "-",
        "n of Eq. 20, as long as the fit of F^n keeps to 1 % (Yang & Liu at h = 1.2 dx: 0.4 to 7); "
        "`\"auto\"` and 0: W(0)/W(dx)",
        "auto"),
    detail::number<&Numerics::stress_diffusion>(
        "stress_diffusion", {0.0, 1.0}, 0.0, "h c",
        "cap of the diffusivity; 0 leaves it out; acts between neighbours that yield and have the "
        "same moduli"),
    detail::number<&Numerics::diffusion_shear_gate>("diffusion_shear_gate", {0.0, 1e6}, 20.0, "h^2",
                                                    "diffusivity per shear rate"),
    detail::choice<&Numerics::integrator>(
        "integrator", Integrator::verlet,
        "Verlet's two levels with one sweep a step, or kick-drift-kick with two"),
    detail::number<&Numerics::verlet_restart_interval>(
        "verlet_restart_interval", {1.0, 1e6}, 40.0, "steps",
        "from one forward step to the next, M of Eq. 29"),
    detail::number<&Numerics::cfl>("cfl", {1e-6, 2.0}, 0.2, "-", "CFL number, Eq. 30"),
    detail::number<&Numerics::skin>("skin", {0.0, 2.0}, 0.15, "h", "margin of the neighbour lists"),
    detail::number<&Numerics::density_minimum>(
        "density_minimum", {0.01, 1.0}, 0.5, "-",
        "bound over the reference density; acts with `gradient_correction`"),
    detail::number<&Numerics::density_maximum>(
        "density_maximum", {1.0, 10.0}, 1.2, "-",
        "bound over the reference density; acts with `gradient_correction`"),
    detail::number<&Numerics::sleep>(
        "sleep", {0.0, 1.0}, 0.0, "-",
        "soil at rest is left out until something near it moves; by how much stress may be off at "
        "worst, over the overburden: take 0.05; 0 leaves nothing out"),
    detail::choice<&Numerics::precision>(
        "precision", Precision::real64,
        "of the pair sweep; `mixed` sums pairs in single precision, positions to 2^-19 h, and "
        "keeps the state in double. Soil comes to rest only to about 1e-5 m/s; a run whose grains "
        "get further apart than 2048 h along an axis stops as unstable"),
};

/// The name of the preset, and the rows that differ from it: "paper, with cfl = 0.4".
std::string preset_and_changes(const Numerics& numerics);

}  // namespace scarp
