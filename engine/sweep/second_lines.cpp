// SPDX-License-Identifier: BSD-3-Clause
/// Each term says what it has in a line; here the lines are gone through.
#include "engine/sweep/second_lines.hpp"

#include <algorithm>
#include <array>

#include "engine/parallel.hpp"
#include "kernels/pair/term_rows.hpp"

namespace scarp {
namespace {

using kernels::FieldUse;
using kernels::TermRow;

/// A term with the arrays that its line is made of.
struct Source {
  const TermRow* row;
  std::vector<const double*> fields;
};

std::vector<Source> sources(const ParticleBuffers& particles, kernels::TermSet terms) {
  std::vector<Source> all;
  for (const TermRow& row : kernels::term_rows) {
    if (!terms.has(row.term) || row.second_line == nullptr) continue;
    Source source{&row, {}};
    for (const FieldUse& use : row.reads_fields) {
      for (int c = 0; c < use.components; ++c)
        source.fields.push_back(particles.component(field_of(use), c));
    }
    all.push_back(std::move(source));
  }
  return all;
}

/// Whether visit(slot) is true for any soil particle.
template <class Visit>
bool any_particle(int threads, const ParticleBuffers& particles, bool stop_at_first,
                  Visit&& visit) {
  bool any = false;
  for (const ParticleGroup& group : particles.groups()) {
    const auto look = [&](std::int64_t begin, std::int64_t end) {
      int found = 0;
      for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
        if (visit(k)) found = 1;
        if (found != 0 && stop_at_first) break;
      }
      return found;
    };
    any |= parallel_reduce(threads, group.count, particle_chunk, 0, look,
                           [](int& total, int part) { total |= part; }) != 0;
  }
  return any;
}

}  // namespace

bool pack_second_lines(int threads, const SecondSources& soil, const ChosenKernels& chosen,
                       Records& records) {
  const int dimension = soil.owned.dimension();
  bool any = false;
  const auto each_role = [&](auto&& visit) {
    visit(Role::owned, soil.owned);
    if (soil.ghosts.count() > 0) visit(Role::ghost, soil.ghosts);
  };
  const auto write = [&](const Source& source, std::int64_t k, double* line) {
    return source.row->second_line(chosen.settings, dimension, source.fields.data(), k,
                                   line + source.row->first_second);
  };
  if (!records.has_second()) {
    each_role([&](Role, const ParticleBuffers& particles) {
      const std::vector<Source> all = sources(particles, chosen.terms);
      if (all.empty()) return;
      any |= any_particle(threads, particles, true, [&](std::int64_t k) {
        std::array<double, kernels::second_record_size> line{};
        return std::any_of(all.begin(), all.end(),
                           [&](const Source& source) { return write(source, k, line.data()); });
      });
    });
    if (!any) return false;
    records.take_second();
  }
  any = false;
  each_role([&](Role role, const ParticleBuffers& particles) {
    const std::vector<Source> all = sources(particles, chosen.terms);
    const std::int64_t first = records.layout()[role].first;
    any |= any_particle(threads, particles, false, [&](std::int64_t k) {
      double* line = records.second(first + k);
      std::uint8_t& mark = records.mark(first + k);
      bool found = false;
      for (const Source& source : all) {
        if (write(source, k, line)) {
          found = true;
        } else if (mark != 0) {
          std::fill_n(line + source.row->first_second, source.row->second_slots, 0.0);
        }
      }
      mark = found ? 1 : 0;
      return found;
    });
  });
  return any;
}

}  // namespace scarp
