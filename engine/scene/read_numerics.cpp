// SPDX-License-Identifier: BSD-3-Clause
/// [numerics]: one row per member of `Numerics`, under its own name.
#include "engine/scene/numerics_list.hpp"
#include "engine/scene/read_parts.hpp"

namespace scarp::input {
namespace {

double read(const NumericsRow& row, const Value& value) {
  switch (row.kind) {
    case NumericsRow::Kind::truth:
      return value.boolean() ? 1.0 : 0.0;
    case NumericsRow::Kind::integer:
      return value.integer();
    case NumericsRow::Kind::choice:
      return static_cast<double>(value.choice(row.words));
    case NumericsRow::Kind::number:
      break;
  }
  if (!row.words.empty() && value.is_text()) return static_cast<double>(value.choice(row.words));
  return value.number(kernels::Unit::none);
}

}  // namespace

void read_numerics(const Value& section, Numerics& numerics) {
  Keys known;
  for (const NumericsRow& row : numerics_list) known.push_back(row.key);
  const Table table = section.table(known);
  for (const NumericsRow& row : numerics_list) {
    if (const auto value = table.find(row.key)) row.set(numerics, read(row, *value));
  }
}

}  // namespace scarp::input
