// SPDX-License-Identifier: BSD-3-Clause
/// Rows of the numerics by their kind.
#include "engine/output/numerics_json.hpp"

#include <string>

#include "engine/scene/numerics_list.hpp"
#include "engine/scene/smoothing_choice.hpp"

namespace scarp {

nlohmann::ordered_json numerics_json(const Scene& scene) {
  const Numerics numerics = filled_in(scene);
  nlohmann::ordered_json json;
  for (const NumericsRow& row : numerics_list) {
    const double value = row.get(numerics);
    switch (row.kind) {
      case NumericsRow::Kind::truth:
        json[std::string(row.key)] = value != 0.0;
        break;
      case NumericsRow::Kind::integer:
        json[std::string(row.key)] = static_cast<int>(value);
        break;
      case NumericsRow::Kind::choice:
        json[std::string(row.key)] = row.written(numerics);
        break;
      case NumericsRow::Kind::number:
        json[std::string(row.key)] = value;
        break;
    }
  }
  return json;
}

}  // namespace scarp
