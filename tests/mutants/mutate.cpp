// SPDX-License-Identifier: BSD-3-Clause
/// Changes of a scene's text by line, number and quoted word.
#include "tests/mutants/mutate.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <string_view>

namespace scarp {
namespace {

using Lines = std::vector<std::string>;

std::size_t below(Random& random, std::size_t end) { return random() % end; }

template <class List>
const auto& one_of(const List& list, Random& random) {
  return list[below(random, std::size(list))];
}

constexpr std::array numbers{"0",
                             "-0.0",
                             "1",
                             "-1",
                             "2",
                             "3",
                             "0.5",
                             "1e-3",
                             "1e-9",
                             "1e-12",
                             "1e-300",
                             "1e9",
                             "1e10",
                             "1e15",
                             "1e300",
                             "-1e300",
                             "1e308",
                             "4.9e-324",
                             "nan",
                             "-nan",
                             "inf",
                             "-inf",
                             "1e400",
                             "999999999",
                             "1000001",
                             "-1e-9",
                             "0.9999999999",
                             "1e6",
                             "-1e6",
                             "1e7",
                             "0x7f",
                             "0b11",
                             "1_000",
                             "9223372036854775807",
                             "-9223372036854775808",
                             "18446744073709551616",
                             "00",
                             "+5",
                             "1.",
                             ".5",
                             "1979-05-27",
                             "true",
                             "[]",
                             "{}",
                             "\"\"",
                             "[1, 2]",
                             "\"auto\"",
                             "\"rest\""};
constexpr std::array units{"m",     "mm",  "cm",    "km",       "ft",    "in",          "s",
                           "us",    "ms",  "min",   "h",        "m/s",   "Pa",          "kPa",
                           "MPa",   "GPa", "psf",   "ksf",      "psi",   "deg",         "rad",
                           "kN/m3", "pcf", "kg/m3", "t/m3",     "g/cm3", "m/s2",        "km/h",
                           "kN/m2", "KPA", "",      "\xC2\xB0", "mPa",   "kN/m\xC2\xB3"};
// Text as people and scripts write it, and what terminals, pages and tables would run.
constexpr std::array texts{R"("")",
                           R"(" ")",
                           R"("a b")",
                           R"("=1+1")",
                           R"("@x")",
                           R"("-x")",
                           R"("+x")",
                           R"("<b>x</b>")",
                           R"("&amp;")",
                           R"("%s%n%x")",
                           R"("{}")",
                           R"("{0}")",
                           R"("$x$")",
                           R"("$\\frac{")",
                           R"("../../x")",
                           R"("x/y")",
                           R"("\u0000")",
                           R"("\u001b[31mx")",
                           R"("\n")",
                           R"("\r")",
                           R"("\t")",
                           R"("\u0007")",
                           R"("\u202ex")",
                           R"("\u2028")",
                           R"("\u0085")",
                           R"("\ufeff")",
                           R"("\U0001F600")",
                           R"("\u6d4b")",
                           R"("'")",
                           R"("\"")",
                           R"("\\")",
                           R"("x;y")",
                           R"("x,y")",
                           R"("x.y")",
                           R"("_x")",
                           R"("CON")",
                           R"("-")",
                           R"("clay")",
                           R"("soil")",
                           R"("sand")",
                           R"("settle")",
                           R"("fail")",
                           R"("rest")",
                           R"("no_slip")",
                           R"("free_slip")",
                           R"("zero")",
                           R"("geostatic")",
                           R"("uniform")",
                           R"("outer")",
                           R"("inner")",
                           R"("plane_strain")",
                           R"("linear_elastic")",
                           R"("drucker_prager")",
                           R"("mohr_coulomb")",
                           R"("paper")",
                           R"("modern")",
                           R"("mixed")",
                           R"("verlet")",
                           R"("kick_drift_kick")",
                           R"("radial")",
                           R"("x")",
                           R"("y")",
                           R"("1/x")",
                           R"~("sqrt(-x)")~",
                           R"("x^1000")",
                           R"("0/0")",
                           R"("(((((x")",
                           R"("x, y")",
                           R"("x ? y : z")",
                           R"("1e999")"};
constexpr std::array lines{"dimension = 3",
                           "dimension = 2",
                           "gravity = [0, 0]",
                           "gravity = [0, 9.81]",
                           "gravity = [5, -8]",
                           "gravity = [0, 0, -9.81]",
                           "preset = \"paper\"",
                           "unit_weight = \"18 kN/m3\"",
                           "velocity = [0, -1]",
                           "velocity = [1e5, 0]",
                           "velocity_field = [\"-y\", \"x\"]",
                           "motion = {velocity = [0.1, 0]}",
                           "motion = {velocity = [0, 0, 1]}",
                           "until = \"rest\"",
                           "damping = 1e6",
                           "damping = \"auto\"",
                           "strength_reduction = 1000",
                           "strength_reduction = 0.001",
                           "reset = true",
                           "rest_velocity = 1e-12",
                           "[initial]\nstress = \"geostatic\"",
                           "[initial]\nstress = \"uniform\"\nuniform = [1e12, 1e12, 1e12, 0]",
                           "k0 = 10",
                           "[run]\nretry = 2",
                           "[output]\nenergy = true",
                           "[output]\nevery = 1e-9",
                           "[numerics]\nprecision = \"mixed\"",
                           "[numerics]\nintegrator = \"verlet\"",
                           "[numerics]\ncfl = 2",
                           "[numerics]\nartificial_stress = 0.3",
                           "[numerics]\nskin = 0",
                           "[numerics]\nsmoothing_ratio = 3",
                           "[numerics]\nviscosity_alpha = 0\nstress_diffusion = 0",
                           "[numerics]\ngradient_correction = false",
                           "a.b.c.d.e.f = 1",
                           "water = true",
                           "[[probe]]\nname = \"p\"\nat = [0, 0]",
                           "[[stage]]\nname = \"q\"\nduration = \"1 ms\""};

Lines split(const std::string& text) {
  Lines all;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    all.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return all;
}

std::string joined(const Lines& all) {
  std::string text;
  for (const std::string& line : all) text += line + "\n";
  return text;
}

struct Span {
  std::size_t begin = 0, end = 0;
};

/// Numbers of a line, those in quotes too, up to a comment.
std::vector<Span> numbers_in(const std::string& line) {
  std::vector<Span> found;
  const std::size_t stop = std::min(line.find('#'), line.size());
  const auto in = [&](std::size_t at, std::string_view letters) {
    return at < stop && letters.find(line[at]) != std::string_view::npos;
  };
  for (std::size_t at = std::min(line.find('='), stop); at < stop;) {
    const bool begins = in(at, "0123456789") || (in(at, "+-.") && in(at + 1, "0123456789"));
    if (!begins || (at > 0 && (std::isalpha(static_cast<unsigned char>(line[at - 1])) != 0))) {
      ++at;
      continue;
    }
    const std::size_t begin = at++;
    while (in(at, "0123456789.") || (in(at, "eE") && in(at + 1, "+-0123456789")) ||
           (in(at, "+-") && in(at - 1, "eE")))
      ++at;
    found.push_back({begin, at});
  }
  return found;
}

std::vector<Span> quotes_in(const std::string& line) {
  std::vector<Span> found;
  for (std::size_t at = line.find('"'); at != std::string::npos; at = line.find('"', at)) {
    const std::size_t end = line.find('"', at + 1);
    if (end == std::string::npos) break;
    found.push_back({at, end + 1});
    at = end + 1;
  }
  return found;
}

void replace(std::string& line, const Span& span, std::string_view with) {
  line.replace(span.begin, span.end - span.begin, with);
}

std::string scaled(const std::string& number, double factor) {
  return std::to_string(std::strtod(number.c_str(), nullptr) * factor);
}

void change_number(Lines& all, Random& random) {
  std::string& line = all[below(random, all.size())];
  const std::vector<Span> found = numbers_in(line);
  if (found.empty()) return;
  const Span& span = one_of(found, random);
  const std::string old = line.substr(span.begin, span.end - span.begin);
  static constexpr std::array factors{-1.0, 1e-3, 1e3, 0.1, 10.0, 0.5, 2.0, 0.99, 1.01, 1e-6, 1e6};
  if (below(random, 2) == 0) return replace(line, span, scaled(old, one_of(factors, random)));
  replace(line, span, one_of(numbers, random));
}

/// Geometry turned over, stretched or squeezed flat.
void scale_line(Lines& all, Random& random) {
  std::string& line = all[below(random, all.size())];
  static constexpr std::array factors{-1.0, 0.0, 0.1, 10.0, 1e-3, 1e5, 1.0 / 3.0};
  const double factor = one_of(factors, random);
  std::vector<Span> found = numbers_in(line);
  std::reverse(found.begin(), found.end());
  for (const Span& span : found) {
    if (below(random, 4) != 0)
      replace(line, span, scaled(line.substr(span.begin, span.end - span.begin), factor));
  }
}

void reverse_points(Lines& all, Random& random) {
  std::string& line = all[below(random, all.size())];
  std::vector<Span> found = numbers_in(line);
  if (found.size() < 4) return;
  std::vector<std::string> values;
  for (const Span& span : found) values.push_back(line.substr(span.begin, span.end - span.begin));
  if (below(random, 2) == 0) {
    std::reverse(values.begin(), values.end());
  } else {
    std::shuffle(values.begin(), values.end(), random);
  }
  for (std::size_t k = found.size(); k-- > 0;) replace(line, found[k], values[k]);
}

void change_unit(Lines& all, Random& random) {
  std::string& line = all[below(random, all.size())];
  const std::vector<Span> found = numbers_in(line);
  if (found.empty()) return;
  const Span& span = one_of(found, random);
  const std::string number = line.substr(span.begin, span.end - span.begin);
  const std::string text = number + " " + one_of(units, random);
  for (const Span& quote : quotes_in(line)) {
    if (quote.begin < span.begin && span.end < quote.end)
      return replace(line, quote, "\"" + text + "\"");
  }
  replace(line, span, "\"" + text + "\"");
}

void change_text(Lines& all, Random& random) {
  std::string& line = all[below(random, all.size())];
  const std::vector<Span> found = quotes_in(line);
  if (!found.empty()) replace(line, one_of(found, random), one_of(texts, random));
}

void drop_line(Lines& all, Random& random) {
  all.erase(all.begin() + static_cast<std::ptrdiff_t>(below(random, all.size())));
}

void swap_values(Lines& all, Random& random) {
  std::string &a = all[below(random, all.size())], &b = all[below(random, all.size())];
  const std::size_t at = a.find('='), bt = b.find('=');
  if (&a == &b || at == std::string::npos || bt == std::string::npos) return;
  const std::string value = a.substr(at);
  a.replace(at, std::string::npos, b.substr(bt));
  b.replace(bt, std::string::npos, value);
}

/// From one [section] up to the next.
Span section_at(const Lines& all, std::size_t from) {
  const auto heads = [&](std::size_t k) { return !all[k].empty() && all[k][0] == '['; };
  Span section{from, from + 1};
  while (section.begin > 0 && !heads(section.begin)) --section.begin;
  while (section.end < all.size() && !heads(section.end)) ++section.end;
  return section;
}

void move_section(Lines& all, Random& random) {
  const Span s = section_at(all, below(random, all.size()));
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(s.begin);
  const auto last = all.begin() + static_cast<std::ptrdiff_t>(s.end);
  const Lines section(first, last);
  const std::size_t choice = below(random, 3);
  if (choice != 0) all.erase(first, last);  // 0: twice
  if (choice != 1) all.insert(all.end(), section.begin(), section.end());
  if (all.empty()) all.emplace_back();
}

void add_line(Lines& all, const Lines& other, Random& random) {
  const std::string line = below(random, 2) == 0 ? std::string(one_of(lines, random))
                                                 : std::string(one_of(other, random));
  all.insert(all.begin() + static_cast<std::ptrdiff_t>(below(random, all.size() + 1)), line);
}

/// Bytes that are wrong at any place.
std::string with_wrong_bytes(std::string text, Random& random) {
  static constexpr std::string_view likely = "[]{}=\"'.,#\n\\ 0-ex\xC3\xFF\r\t";
  const std::size_t count = 1 + below(random, 4);
  for (std::size_t k = 0; k < count && !text.empty(); ++k)
    text[below(random, text.size())] = likely[below(random, likely.size())];
  if (below(random, 4) == 0) text.resize(below(random, text.size() + 1));
  return text;
}

using Change = void (*)(Lines&, const Lines&, Random&);

template <void (*Of)(Lines&, Random&)>
void change(Lines& all, const Lines&, Random& random) {
  Of(all, random);
}

/// Those that leave most scenes readable stand here more often.
constexpr std::array<Change, 20> changes{
    change<change_number>, change<change_number>, change<change_number>,  change<change_number>,
    change<change_number>, change<change_number>, change<scale_line>,     change<scale_line>,
    change<scale_line>,    change<change_unit>,   change<change_unit>,    change<change_text>,
    change<change_text>,   change<change_text>,   change<reverse_points>, change<reverse_points>,
    change<drop_line>,     change<swap_values>,   change<move_section>,   add_line};

}  // namespace

std::string mutate(const std::string& scene, const std::vector<std::string>& others,
                   Random& random) {
  if (below(random, 50) == 0) return with_wrong_bytes(scene, random);
  Lines all = split(scene);
  const Lines other = split(one_of(others, random));
  const std::size_t count = 1 + below(random, 4);
  for (std::size_t k = 0; k < count && !all.empty(); ++k) {
    one_of(changes, random)(all, other, random);
  }
  return joined(all);
}

}  // namespace scarp
