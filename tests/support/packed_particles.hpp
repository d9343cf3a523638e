// SPDX-License-Identifier: BSD-3-Clause
/// Packs plain SI particles into the records and neighbour lists that the sweeps read, by brute
/// force.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

#include "engine/neighbours/neighbour_blocks.hpp"
#include "engine/scene/tension_factor_fit.hpp"
#include "kernels/pair/list.hpp"
#include "kernels/pair/pair_sweep_reference.hpp"
#include "kernels/particle_view.hpp"
#include "kernels/smoothing/list.hpp"

namespace scarp::test {

inline constexpr double far_position = 1e8;  ///< in units of h

inline const kernels::SmoothingForm& form_of(kernels::ReferenceSmoothing smoothing) {
  return kernels::smoothing_functions[static_cast<std::size_t>(smoothing)];
}

/// Coefficients as documented in particle_view.hpp; values in units of alpha_D / h^d.
inline kernels::SmoothingView<double> smoothing_view(const kernels::SmoothingForm& form) {
  kernels::SmoothingView<double> view{};
  for (int k = 0; k < 3; ++k) {
    view.derivative[k] = form.derivative(k);
    view.value[k] = form.value[k];
  }
  view.derivative_inner = form.derivative(3);
  view.value_inner = form.value_inner;
  return view;
}

/// Owner of one neighbour list: every source within reach of any member of a cluster.
struct PackedLists {
  NeighbourBlocks blocks;
  std::vector<std::int64_t> soil_begin, wall_begin, wall_end;
  std::int32_t far_record = 0;

  kernels::NeighbourView view() const {
    return {blocks.page().data(), blocks.place().data(), soil_begin.data(),
            wall_begin.data(),    wall_end.data(),       far_record};
  }
};

/// What the records are packed for: where gradients are corrected, the sweeps of gradients and of
/// forces find different values in them.
enum class Packing { plain, corrected_gradient, corrected_force };
inline Packing packing_for(kernels::TermSet terms) {
  if (terms.has(kernels::Term::wall_gradient)) return Packing::corrected_gradient;
  return terms.has(kernels::Term::force_correction) ? Packing::corrected_force : Packing::plain;
}

/// Records and lists for one cluster size. Slots: soil and its padding, dummies and theirs, mirror
/// images, the far record.
class PackedParticles {
 public:
  PackedParticles(const kernels::ReferenceParticles& particles,
                  const kernels::ReferenceSettings& settings, int cluster_size,
                  Packing packing = Packing::plain)
      : settings_(settings), cluster_size_(cluster_size), packing_(packing) {
    const auto padded = [&](std::size_t count) {
      return (static_cast<std::int64_t>(count) + cluster_size - 1) / cluster_size * cluster_size;
    };
    soil_count_ = particles.soil_count;
    wall_count_ = particles.wall_count;
    first_wall_ = padded(soil_count_);
    first_image_ = first_wall_ + padded(wall_count_);
    far_record_ =
        first_image_ + static_cast<std::int64_t>(particles.size() - soil_count_ - wall_count_);
    pack_records(particles);
    build_lists(particles);
    clusters_.resize(static_cast<std::size_t>(soil_clusters()));
    std::iota(clusters_.begin(), clusters_.end(), 0);
  }

  std::int64_t soil_clusters() const { return first_wall_ / cluster_size_; }
  std::int64_t wall_clusters() const { return (first_image_ - first_wall_) / cluster_size_; }
  std::int64_t first_wall() const { return first_wall_; }
  bool is_dummy(std::int64_t slot) const { return slot >= first_wall_ && slot < first_image_; }
  std::int64_t slots() const { return far_record_ + 1; }
  double* record(std::int64_t slot) { return records_.data() + slot * kernels::record_size; }
  double* second(std::int64_t slot) { return second_.data() + slot * kernels::second_record_size; }
  double* extra(std::int64_t slot) { return extra_.data() + slot * kernels::extra_record_size; }
  std::uint8_t& mark(std::int64_t slot) { return marked_[static_cast<std::size_t>(slot)]; }

  /// View without outputs; without marks there is no artificial stress.
  kernels::PairSweepView<double> sweep_view(bool with_marks) const {
    kernels::PairSweepView<double> view{};
    view.records = records_.data();
    if (with_marks) {
      view.second = second_.data();
      view.marked = marked_.data();
    }
    if (packing_ == Packing::corrected_force) view.extra = extra_.data();
    if (!material_.empty()) view.material = material_.data();
    view.constants.hourglass_viscosity = settings_.hourglass_viscosity;
    view.clusters = clusters_.data();
    view.neighbours = lists_.view();
    view.smoothing_length = settings_.smoothing_length;
    const kernels::SmoothingForm& form = form_of(settings_.smoothing);
    view.constants.smoothing = smoothing_view(form);
    view.constants.viscosity_alpha = settings_.viscosity_alpha;
    view.constants.viscosity_beta = settings_.viscosity_beta;
    for (int a = 0; a < 3; ++a) {
      view.constants.gravity[a] =
          settings_.gravity[static_cast<std::size_t>(a)] * settings_.smoothing_length;
    }
    view.constants.tension_factor =
        fit_tension_factor(form, settings_.spacing / settings_.smoothing_length,
                           settings_.tension_exponent)
            .factor;
    return view;
  }
  kernels::WallSweepView<double> wall_view() const {
    kernels::WallSweepView<double> view{};
    view.records = records_.data();
    view.extra = extra_.data();
    view.neighbours = wall_lists_.view();
    view.smoothing = smoothing_view(form_of(settings_.smoothing));
    for (int a = 0; a < 3; ++a) {
      view.gravity[a] = settings_.gravity[static_cast<std::size_t>(a)] * settings_.smoothing_length;
    }
    view.first_wall = first_wall_;
    view.faces = faces_.data();
    return view;
  }

 private:
  void pack_records(const kernels::ReferenceParticles& p) {
    using namespace kernels;
    const double h = settings_.smoothing_length;
    const int dimension = settings_.dimension;
    // normalisation = alpha_D h^d, so alpha_D / h^(d+1) of the documentation is this over h^(d+1).
    const double gradient_factor = form_of(settings_.smoothing).normalisation(dimension) /
                                   (std::pow(h, dimension + 1) * settings_.lattice_moment);
    records_.assign(static_cast<std::size_t>(slots() * record_size), 0.0);
    second_.assign(static_cast<std::size_t>(slots() * second_record_size), 0.0);
    extra_.assign(static_cast<std::size_t>(slots() * extra_record_size), 0.0);
    marked_.assign(static_cast<std::size_t>(slots()), 0);
    faces_.assign(static_cast<std::size_t>((first_image_ - first_wall_) * wall_record_size), 0.0);
    for (std::int64_t slot = 0; slot < slots(); ++slot) {
      records_[static_cast<std::size_t>(slot * record_size + record_x)] = far_position;
      records_[static_cast<std::size_t>(slot * record_size + record_density)] = 1.0;
    }
    if (!p.material.empty()) material_.assign(static_cast<std::size_t>(slots()), 0);
    for (std::size_t k = 0; k < p.size(); ++k) {
      if (!p.material.empty()) material_[static_cast<std::size_t>(slot_of(k))] = p.material[k];
      double* r = records_.data() + slot_of(k) * record_size;
      for (std::size_t a = 0; a < 3; ++a) {
        r[record_x + a] = p.position[k][a] / h;
        r[record_velocity_x + a] = p.velocity[k][a];
      }
      r[record_volume] = p.volume[k] * gradient_factor;
      r[record_density] = p.density[k];
      r[record_sound_speed] = p.sound_speed[k];
      r[record_diffusivity] = p.diffusivity[k] / h;
      double* t = second_.data() + slot_of(k) * second_record_size +
                  first_second<PairTerms, ArtificialStress>;
      for (std::size_t c = 0; c < 6; ++c) {
        r[record_stress + c] = p.stress[k][c];
        t[c] = p.density[k] * p.artificial_stress[k][c];
        if (t[c] != 0.0) marked_[static_cast<std::size_t>(slot_of(k))] = 1;
      }
      if (packing_ == Packing::corrected_force) {
        if (dimension == 2) t[zz] = t[xy];  // R B with B = I here
        for (int a = 0; a < dimension; ++a) {
          for (int b = 0; b < dimension; ++b) {
            const int place = corrected_place_of(dimension, a, b);
            (place < 8 ? r[record_stress + place]
                       : extra(slot_of(k))[corrected_extra + place - 8]) =
                p.force_stress[k][static_cast<std::size_t>(3 * a + b)];
            if (a > b) continue;
            const auto c = static_cast<std::size_t>(tensor_index[a][b]);
            (dimension == 2 ? r[record_stress + strain_rate_place[a][b]]
                            : extra(slot_of(k))[first_second<PairTerms, HourglassViscosity> + c]) =
                0.5 * h * p.strain_rate[k][c];
          }
        }
      }
      if (packing_ == Packing::corrected_gradient && p.is_wall(k)) {
        // The sweep knows W in units of alpha_D / h^d.
        const double unit =
            form_of(settings_.smoothing).normalisation(dimension) / std::pow(h, dimension);
        for (int a = 0; a < dimension; ++a) {
          for (int b = 0; b < dimension; ++b) {
            const int place =
                dimension == 2 ? wall_gradient_place<2>(a, b) : wall_gradient_place<3>(a, b);
            r[record_density + place] =
                gradient_factor * unit * p.wall_gradient[k][static_cast<std::size_t>(3 * a + b)];
          }
        }
      }
      if (p.is_wall(k)) {
        double* w = faces_.data() + (slot_of(k) - first_wall_) * wall_record_size;
        for (std::size_t a = 0; a < 3; ++a) w[wall_normal_x + a] = p.face[k].normal[a];
        w[wall_distance] = p.face[k].distance / h;
        w[wall_limit] = p.face[k].limit;
      }
    }
  }

  void build_lists(const kernels::ReferenceParticles& p) {
    const auto part_of = [&](std::size_t j) {
      if (!p.is_wall(j)) return kernels::Neighbour::soil;
      return p.volume[j] > 0.0 ? kernels::Neighbour::dummy : kernels::Neighbour::inner;
    };
    const auto append = [&](PackedLists& lists, std::size_t first, std::size_t count,
                            kernels::Neighbour part) {
      for (std::size_t j = 0; j < p.size(); ++j) {
        if (part_of(j) != part) continue;
        bool near = false;
        for (std::size_t i = first; i < first + count; ++i) {
          double squared = 0.0;
          for (std::size_t a = 0; a < 3; ++a) {
            squared +=
                (p.position[i][a] - p.position[j][a]) * (p.position[i][a] - p.position[j][a]);
          }
          // A little more than the support: a skin, which must change nothing.
          near |= squared < std::pow(2.05 * settings_.smoothing_length, 2);
        }
        if (near) lists.blocks.add(static_cast<std::int32_t>(slot_of(j)));
      }
      lists.blocks.end_list();
    };
    const auto size = static_cast<std::size_t>(cluster_size_);
    for (std::size_t i = 0; i < static_cast<std::size_t>(first_wall_); i += size) {
      const std::size_t count = std::min(size, soil_count_ - i);
      lists_.soil_begin.push_back(lists_.blocks.size());
      append(lists_, i, count, kernels::Neighbour::soil);
      lists_.wall_begin.push_back(lists_.blocks.size());
      append(lists_, i, count, kernels::Neighbour::dummy);
      lists_.wall_end.push_back(lists_.blocks.size());
      append(lists_, i, count, kernels::Neighbour::inner);
    }
    for (std::size_t i = 0; i < wall_count_; i += size) {
      wall_lists_.soil_begin.push_back(wall_lists_.blocks.size());
      append(wall_lists_, soil_count_ + i, std::min(size, wall_count_ - i),
             kernels::Neighbour::soil);
      wall_lists_.wall_begin.push_back(wall_lists_.blocks.size());
      wall_lists_.wall_end.push_back(wall_lists_.blocks.size());
    }
    for (PackedLists* lists : {&lists_, &wall_lists_}) {
      lists->soil_begin.push_back(lists->blocks.size());
      lists->blocks.append_empty(2);
      lists->far_record = static_cast<std::int32_t>(far_record_);
    }
  }

  std::int64_t slot_of(std::size_t k) const {
    if (k < soil_count_) return static_cast<std::int64_t>(k);
    if (k < soil_count_ + wall_count_)
      return first_wall_ + static_cast<std::int64_t>(k - soil_count_);
    return first_image_ + static_cast<std::int64_t>(k - soil_count_ - wall_count_);
  }

  kernels::ReferenceSettings settings_;
  int cluster_size_;
  Packing packing_;
  std::size_t soil_count_ = 0, wall_count_ = 0;
  std::int64_t first_wall_ = 0, first_image_ = 0, far_record_ = 0;
  AlignedVector<double> records_, second_, extra_, faces_;
  std::vector<std::uint8_t> marked_;
  std::vector<std::int32_t> material_;
  std::vector<std::int32_t> clusters_;
  PackedLists lists_, wall_lists_;
};

/// Output arrays of a sweep over soil clusters, filled with NaN.
struct SweepOutput {
  static constexpr int count = kernels::output_count<kernels::PairTerms>;
  /// First output of each term.
  template <class Term>
  static constexpr int of = kernels::first_output<kernels::PairTerms, Term>;
  static constexpr int density_rate = of<kernels::Continuity>;
  static constexpr int velocity_gradient = of<kernels::VelocityGradient>;
  static constexpr int moment = of<kernels::Moment>;
  static constexpr int diffusion_rate = of<kernels::StressDiffusion>;
  static constexpr int diffusion_slope = diffusion_rate + 6;
  static constexpr int acceleration = of<kernels::Momentum>;
  static constexpr int approach_rate = of<kernels::Viscosity>;

  AlignedVector<double> values;
  std::size_t slots;

  explicit SweepOutput(std::int64_t slot_count)
      : values(static_cast<std::size_t>(slot_count) * count,
               std::numeric_limits<double>::quiet_NaN()),
        slots(static_cast<std::size_t>(slot_count)) {}

  double* field(int index) { return values.data() + static_cast<std::size_t>(index) * slots; }
  void attach(kernels::PairSweepView<double>& view) {
    for (int k = 0; k < count; ++k) view.output[k] = field(k);
  }
};

}  // namespace scarp::test
