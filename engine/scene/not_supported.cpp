// SPDX-License-Identifier: BSD-3-Clause
/// Words of other programs' input, by the part of a scene in which they would stand.
#include "engine/scene/not_supported.hpp"

#include <algorithm>
#include <iterator>

namespace scarp::input {
namespace {

struct Row {
  std::string_view sections;  // in which it is looked for; "*": in all
  std::string_view roots;     // the word holds one of them
  std::string_view answer;
};

// The first row that fits answers.
constexpr Row rows[] = {
    {"initial", "hydrostatic|isotropic",
     "a stress that is equal in all directions is not one of the words. Try stress = \"geostatic\" "
     "with "
     "k0 = 1, or \"uniform\"."},
    {"*", "water|pore|phreatic|piezo|hydro|seepage|saturat|drain|suction|permeab|consolid",
     "water and its pressure are not supported. Try total stresses: the saturated density, with "
     "the "
     "undrained strength (friction_angle = 0, cohesion = s_u) where soil has no time to drain; or "
     "the buoyant density for drained soil under still water."},
    {"*", "earthquake|seismic|accelerogram|ground_motion|kh|kv",
     "earthquakes are not supported as such. Try a tilted gravity, [k_h g, -g], for a "
     "pseudo-static "
     "one."},
    {"wall", "angular|rotat|omega|spin|pivot|hinge",
     "walls do not turn, only translation is supported. Try motion = {velocity = [..]} of several "
     "short walls."},
    {"top wall body material stage initial", "surcharge|traction|load|force",
     "loads on a surface are not supported. Try a [[body]] of the load's weight on top "
     "(linear_elastic, density = load over g and height), or a moving wall as a footing."},
    {"top body stage initial", "pressure",
     "pressures on a surface are not supported. Try a [[body]] of the same weight on top, or "
     "stress = \"uniform\" for the soil's own stress at the start."},
    {"wall", "friction|adhesion|coulomb|partial|interface",
     "walls with friction of their own are not supported. Try kind = \"no_slip\", where soil "
     "slides "
     "by its own strength, or kind = \"free_slip\"; a thin layer of weaker soil stands for a "
     "smoother "
     "contact."},
    {"wall", "rough|fixed|stick|smooth|roller|symmetr",
     "walls are rough or smooth. Try kind = \"no_slip\", or kind = \"free_slip\" for smooth ones "
     "and for "
     "symmetry planes."},
    {"top wall body numerics", "periodic|cyclic",
     "periodic boundaries are not supported. Try kind = \"free_slip\" walls, which act as symmetry "
     "planes."},
    {"top wall numerics", "absorb|viscous_boundary|lysmer|quiet|inflow|outflow|open_boundary",
     "absorbing and open boundaries are not supported. Try walls further away, with damping in the "
     "stage that settles."},
    {"top body material", "contact|interface|joint",
     "contact between bodies is not supported: soil that touches sticks together. Try a wall in "
     "between, or a thin layer of a weaker material."},
    {"top body wall material",
     "anchor|nail|geotextile|geogrid|reinforce|bolt|strut|beam|sheet|pile|fiber",
     "anchors, nails, geotextiles and beams are not supported. Try a [[body]] of a linear_elastic "
     "material, at least three spacings thick, or cohesion that stands for what is reinforced."},
    {"material", "unit_wt|gamma|specific_weight", "the key is unit_weight. Try \"18 kN/m3\"."},
    {"material", "shear_modulus|bulk_modulus",
     "elasticity is given by E and nu. Try youngs_modulus = 9 K G / (3 K + G) and poisson_ratio = "
     "(3 K - 2 G) / (6 K + 2 G)."},
    {"material", "harden|peak|degrad|critical_state|void_ratio|ocr|preconsolidation",
     "hardening and critical states are not supported. Try residual_cohesion, "
     "residual_friction_angle and softening_slip for strength that falls."},
    {"material", "soften|residual",
     "strength falls by residual_cohesion, residual_friction_angle, softening and softening_slip, "
     "in "
     "models with a cohesion."},
    {"material", "tension|tensile",
     "the cone of drucker_prager ends at c / tan phi. Try model = \"mohr_coulomb\", which has a "
     "tensile_strength."},
    {"numerics", "plasticity|near_yield_limiter",
     "stress always returns to the yield surface in closed form; the paper's rate forms are shown "
     "in "
     "the validation case `element` alone. Try without it."},
    {"material", "viscosity|rheology|yield_stress|creep|strain_rate",
     "strength that depends on the rate of strain is not supported. Try the strength of the rate "
     "that "
     "matters, and viscosity_alpha under [numerics] for damping."},
    {"top material body", "temperature|thermal|erosion|entrain",
     "temperature and erosion are not supported. Try [[body]] for the bed that can be carried "
     "off."},
    {"body", "friction|cohesion|young|poisson|density|angle",
     "properties belong to a [[material]]. Try material = \"name\" here."},
    {"body", "rotation|angular|omega|spin",
     "a body has no rotation of its own. Try velocity_field = [\"-2*y\", \"2*x\"]."},
    {"body initial", "random|porosity|pack",
     "particles lie on a lattice, random packings are not supported. Try without it."},
    {"model",
     "cam|hardening|hoek|brown|mises|tresca|elastoplastic|rheology|bingham|hypoplastic|norsand",
     "only drucker_prager, mohr_coulomb and linear_elastic are supported. Try friction_angle = 0, "
     "with "
     "model = \"drucker_prager\" for von Mises and model = \"mohr_coulomb\" for Tresca."},
    {"*", "include|import|mesh|stl|dxf",
     "a scene reads no other file. Try to write the points of outlines into [[body]] and "
     "[[wall]]."},
};

/// Whether `list` has one of its words, apart by `separator`, for which `fits` holds.
template <class Fits>
bool any_of(std::string_view list, char separator, const Fits& fits) {
  while (!list.empty()) {
    const std::size_t end = std::min(list.find(separator), list.size());
    if (fits(list.substr(0, end))) return true;
    list.remove_prefix(std::min(end + 1, list.size()));
  }
  return false;
}

/// At the beginning of the word or of one of its parts; short roots are whole parts.
bool holds(std::string_view word, std::string_view root) {
  for (std::size_t at = word.find(root); at != std::string_view::npos;
       at = word.find(root, at + 1)) {
    if (at > 0 && word[at - 1] != '_' && word[at - 1] != '-') continue;
    const std::size_t end = at + root.size();
    const bool whole = end == word.size() || word[end] == '_' || word[end] == '-';
    if (root.size() > 3 || whole) return true;
  }
  return false;
}

}  // namespace

std::string_view not_supported(std::string_view section, std::string_view word) {
  const auto row = std::find_if(std::begin(rows), std::end(rows), [&](const Row& r) {
    const bool here =
        r.sections == "*" || any_of(r.sections, ' ', [&](auto name) { return name == section; });
    return here && any_of(r.roots, '|', [&](auto root) { return holds(word, root); });
  });
  return row == std::end(rows) ? std::string_view{} : row->answer;
}

}  // namespace scarp::input
