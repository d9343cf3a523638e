// SPDX-License-Identifier: GPL-2.0-only
/// The division of the soil among processes, by LAMMPS.
#include "engine/distributed/decomposition.hpp"

#include <atom.h>
#include <comm.h>
#include <domain.h>
#include <lammps.h>
#include <library.h>
#include <modify.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/distributed/soil_fix.hpp"

namespace scarp::distributed {
namespace {

using LAMMPS_NS::LAMMPS;

std::string exact(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

/// Calls use(row, component) for the stored components of the fields for which is(row) holds.
template <class Is, class Use>
void each_component(const ParticleBuffers& particles, const Is& is, const Use& use) {
  for (const FieldRow& field : particles.rows()) {
    if (!particles.has(field.field) || !is(field)) continue;
    for (int c = 0; c < component_count(field.rank); ++c) {
      if (stores_component(field.rank, c, particles.dimension())) use(field.field, c);
    }
  }
}
bool moves_along(const FieldRow& field) { return field.lifetime == Lifetime::state; }
bool is_of_ghosts(const FieldRow& field) { return field.ghost == Ghost::ghost; }

template <class Is>
std::size_t components(const ParticleBuffers& particles, const Is& is) {
  std::size_t count = 0;
  each_component(particles, is, [&count](Field, int) { ++count; });
  return count;
}

void* opened(MPI_Comm processes) {
  std::string words[] = {"scarp-lammps", "-screen", "none", "-log", "none", "-nocite"};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  return lammps_open(static_cast<int>(arguments.size()), arguments.data(), processes, nullptr);
}

/// Ids with the slots they stand in, ascending.
std::vector<std::pair<std::int64_t, std::int64_t>> slots_of_ids(const ParticleBuffers& particles) {
  std::vector<std::pair<std::int64_t, std::int64_t>> slots;
  for (const ParticleGroup& group : particles.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k)
      slots.emplace_back(particles.ids()[static_cast<std::size_t>(k)], k);
  }
  std::sort(slots.begin(), slots.end());
  return slots;
}

}  // namespace

int loaded_lammps_release() {
  void* const lammps = opened(MPI_COMM_SELF);
  const int release = lammps_version(lammps);
  lammps_close(lammps);
  return release;
}

struct Decomposition::Box {
  Box(MPI_Comm processes, const ParticleBuffers& soil, double halo);
  Box(const Box&) = delete;
  Box& operator=(const Box&) = delete;
  ~Box() { lammps_close(lammps); }

  void command(const std::string& text) { lammps_command(lammps, text.c_str()); }
  std::size_t own_count() const { return static_cast<std::size_t>(lammps->atom->nlocal); }
  std::int64_t id(std::size_t index) const { return std::int64_t{lammps->atom->tag[index]} - 1; }
  std::size_t group(std::size_t index) const {
    return static_cast<std::size_t>(lammps->atom->type[index]) - 1;
  }
  void share_out(bool cut);
  void take_arrays(const ParticleBuffers& soil);
  void find_places(const ParticleBuffers& soil);
  std::int64_t take_in(ParticleBuffers& soil);
  void renew_ghosts(const ParticleBuffers& soil, ParticleBuffers& ghosts);

  LAMMPS* lammps;
  SoilFix* fix = nullptr;
  bool places_known = false;
};

Decomposition::Box::Box(MPI_Comm processes, const ParticleBuffers& soil, double halo)
    : lammps(static_cast<LAMMPS*>(opened(processes))) {
  const bool flat = soil.dimension() == 2;
  command(std::string("dimension ") + (flat ? "2" : "3"));
  command(std::string("boundary s s ") + (flat ? "p" : "s"));
  command("atom_style atomic");
  command("atom_modify sort 0 0.0");
  command("comm_style tiled");
  command("neighbor 0.0 bin");
  command("comm_modify cutoff " + exact(halo));
  // The box shrinks and grows with the soil; at first it has to hold it.
  std::string region = "region soil block";
  for (int a = 0; a < 3; ++a) {
    double low = -0.5, high = 0.5;
    if (const double* position = soil.component(Field::position, a)) {
      low = std::numeric_limits<double>::infinity(), high = -low;
      for (const ParticleGroup& group : soil.groups()) {
        for (std::int64_t k = group.first; k < group.end(); ++k) {
          low = std::min(low, position[k]);
          high = std::max(high, position[k]);
        }
      }
      low -= halo, high += halo;
    }
    for (const double side : {low, high}) region.append(" ").append(exact(side));
  }
  command(region);
  command("create_box " + std::to_string(soil.groups().size()) + " soil");
  command("mass * 1.0");
  (*lammps->modify->fix_map)["scarp"] = [](LAMMPS* of, int count, char** words) -> LAMMPS_NS::Fix* {
    return new SoilFix(of, count, words);
  };
  command("fix soil all scarp " + std::to_string(components(soil, moves_along)) + " " +
          std::to_string(components(soil, is_of_ghosts)));
  fix = static_cast<SoilFix*>(lammps->modify->fix[lammps->modify->find_fix("soil")]);
}

/// Particles go to the process in whose part they are.
void Decomposition::Box::share_out(bool cut) {
  if (cut) command("balance 1.0 rcb");
  lammps->domain->pbc();
  lammps->domain->reset_box();
  lammps->comm->setup();
  lammps->comm->exchange();
}

void Decomposition::Box::take_arrays(const ParticleBuffers& soil) {
  fix->carried.clear();
  each_component(soil, moves_along,
                 [&](Field field, int c) { fix->carried.push_back(soil.component(field, c)); });
}

/// Slots of the particles by LAMMPS's own numbers.
void Decomposition::Box::find_places(const ParticleBuffers& soil) {
  const auto slots = slots_of_ids(soil);
  for (std::size_t k = 0; k < own_count(); ++k) {
    fix->place[k] =
        std::lower_bound(slots.begin(), slots.end(), std::pair{id(k), std::int64_t{0}})->second;
  }
  places_known = true;
}

Decomposition::Decomposition(MPI_Comm processes, const ParticleBuffers& soil, double halo,
                             bool rebalance, int threads)
    : box_(std::make_unique<Box>(processes, soil, halo)), rebalance_(rebalance) {
  box_->fix->threads = threads;
}

Decomposition::~Decomposition() = default;

void Decomposition::divide(ParticleBuffers& soil) {
  std::vector<int> ids, types;
  std::vector<double> positions;
  for (std::size_t g = 0; g < soil.groups().size(); ++g) {
    const ParticleGroup& group = soil.groups()[g];
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      ids.push_back(static_cast<int>(soil.ids()[static_cast<std::size_t>(k)]) + 1);
      types.push_back(static_cast<int>(g) + 1);
      for (int a = 0; a < 3; ++a) {
        const double* position = soil.component(Field::position, a);
        positions.push_back(position != nullptr ? position[k] : 0.0);
      }
    }
  }
  Box& box = *box_;
  lammps_create_atoms(box.lammps, static_cast<int>(ids.size()), ids.data(), types.data(),
                      positions.data(), nullptr, nullptr, 1);
  box.find_places(soil);
  box.take_arrays(soil);
  // The first cut is of the box that was made, the second of the one that fits, as all later ones.
  box.share_out(true);
  box.share_out(true);
  // What came is here already, as all soil is.
  box.fix->came.clear();
  std::vector<std::int64_t> own;
  for (std::size_t k = 0; k < box.own_count(); ++k) own.push_back(box.id(k));
  std::sort(own.begin(), own.end());
  std::vector<std::int64_t> others;
  for (const ParticleGroup& group : soil.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      if (!std::binary_search(own.begin(), own.end(), soil.ids()[static_cast<std::size_t>(k)]))
        others.push_back(k);
    }
  }
  soil.remove(others);
  box.find_places(soil);
}

void Decomposition::deal(ParticleBuffers& soil, ParticleBuffers& ghosts) {
  Box& box = *box_;
  const SoilFix& fix = *box.fix;
  if (!box.places_known) box.find_places(soil);
  LAMMPS& lammps = *box.lammps;
  for (int a = 0; a < soil.dimension(); ++a) {
    const double* position = soil.component(Field::position, a);
    for (std::size_t k = 0; k < box.own_count(); ++k) lammps.atom->x[k][a] = position[fix.place[k]];
  }
  box.take_arrays(soil);
  box.share_out(rebalance_);
  lammps.comm->borders();
  ++traffic_.deals;

  traffic_.moved += box.take_in(soil);
  box.renew_ghosts(soil, ghosts);
}

/// Lets go of what has left, and takes in what has come; returns how much that is.
std::int64_t Decomposition::Box::take_in(ParticleBuffers& soil) {
  std::vector<char> stays(static_cast<std::size_t>(soil.slots()), 0);
  for (std::size_t k = 0; k < own_count(); ++k) {
    if (fix->place[k] >= 0) stays[static_cast<std::size_t>(fix->place[k])] = 1;
  }
  std::vector<std::pair<std::int64_t, std::int64_t>> left;  // ids and slots
  for (const auto& [id, slot] : slots_of_ids(soil)) {
    if (stays[static_cast<std::size_t>(slot)] == 0) left.emplace_back(id, slot);
  }
  struct Arrival {
    std::int64_t id, from;
  };
  std::vector<std::vector<Arrival>> arrivals(soil.groups().size());
  for (std::size_t k = 0; k < own_count(); ++k) {
    if (fix->place[k] >= 0) continue;
    // A cut runs through a particle, which may so go to the other side and back.
    const auto before =
        std::lower_bound(left.begin(), left.end(), std::pair{id(k), std::int64_t{0}});
    if (before != left.end() && before->first == id(k)) {
      left.erase(before);
    } else {
      arrivals[group(k)].push_back({id(k), -1 - fix->place[k]});
    }
  }
  std::vector<std::int64_t> leaving;
  for (const auto& [id, slot] : left) leaving.push_back(slot);
  std::sort(leaving.begin(), leaving.end());
  std::vector<std::vector<std::int64_t>> ids(arrivals.size());
  std::int64_t count = 0;
  for (std::size_t g = 0; g < arrivals.size(); ++g) {
    std::sort(arrivals[g].begin(), arrivals[g].end(),
              [](const Arrival& a, const Arrival& b) { return a.id < b.id; });
    for (const Arrival& arrival : arrivals[g]) ids[g].push_back(arrival.id);
    count += std::ssize(ids[g]);
  }
  if (!leaving.empty() || count > 0) {
    const std::vector<std::int64_t> first = soil.exchange(leaving, ids);
    std::size_t column = 0;
    const std::size_t width = fix->carried.size();
    each_component(soil, moves_along, [&](Field field, int c) {
      double* const to = soil.component(field, c);
      for (std::size_t g = 0; g < arrivals.size(); ++g) {
        for (std::size_t k = 0; k < arrivals[g].size(); ++k)
          to[first[g] + static_cast<std::int64_t>(k)] =
              fix->came[static_cast<std::size_t>(arrivals[g][k].from) * width + column];
      }
      ++column;
    });
  }
  fix->came.clear();
  places_known = false;
  return count;
}

void Decomposition::Box::renew_ghosts(const ParticleBuffers& soil, ParticleBuffers& ghosts) {
  const LAMMPS_NS::Atom& atom = *lammps->atom;
  const std::size_t first = own_count(), count = static_cast<std::size_t>(atom.nghost);
  std::vector<std::vector<std::pair<std::int64_t, std::size_t>>> by_group(soil.groups().size());
  for (std::size_t k = 0; k < count; ++k) by_group[group(first + k)].emplace_back(id(first + k), k);
  std::vector<ParticleGroup> groups = soil.groups();
  std::int64_t slots = 0;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::sort(by_group[g].begin(), by_group[g].end());
    groups[g].first = slots;
    groups[g].count = std::ssize(by_group[g]);
    groups[g].capacity = padded(groups[g].count);
    slots += groups[g].capacity;
  }
  std::vector<Field> used;
  for (const FieldRow& field : soil.rows()) {
    if (soil.has(field.field) && is_of_ghosts(field)) used.push_back(field.field);
  }
  ghosts = ParticleBuffers(soil.dimension(), groups, used);
  fix->ghost_place.resize(count);
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::int64_t slot = groups[g].first;
    for (const auto& [id, index] : by_group[g]) {
      ghosts.ids()[static_cast<std::size_t>(slot)] = id;
      for (int a = 0; a < soil.dimension(); ++a)
        ghosts.component(Field::position, a)[slot] = atom.x[first + index][a];
      fix->ghost_place[index] = slot++;
    }
  }
}

void Decomposition::refresh(const ParticleBuffers& soil, ParticleBuffers& ghosts,
                            const DataSet& fields) {
  Box& box = *box_;
  if (!box.places_known) box.find_places(soil);
  box.fix->refreshed.clear();
  each_component(
      ghosts, [&fields](const FieldRow& field) { return fields.has(field.field); },
      [&](Field field, int c) {
        box.fix->refreshed.push_back({soil.component(field, c), ghosts.component(field, c)});
      });
  const auto width = static_cast<int>(box.fix->refreshed.size());
  if (width == 0) return;
  box.lammps->comm->forward_comm_fix(box.fix, width);
  ++traffic_.refreshes;
  traffic_.messages = box.fix->messages;
  traffic_.values = box.fix->values;
}

}  // namespace scarp::distributed
