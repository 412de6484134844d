#include "report/explorer_record.hpp"

#include <nettle/base64.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "base/constants.hpp"
#include "compare/formulas.hpp"
#include "compare/values.hpp"
#include "formula/symbols.hpp"
#include "live/scene_text.hpp"
#include "report/assets.hpp"
#include "report/html.hpp"
#include "report/units.hpp"
#include "rules/rulebook.hpp"

namespace vcrit::validation::report {

namespace {

// Of logarithmic sliders, two decades each way.
constexpr int steps_a_decade = 200, decades_each_way = 2;
// Of Poisson's ratio, in hundredths.
constexpr int usual_least_poisson = 0, least_poisson = -99, most_poisson = 50;

/// A parameter; of an array all entries, by one factor.
struct ExploredRow {
  std::string name;  ///< as for --set
  std::string said;  ///< told from all others: "frequency", "spring k0"
  std::string meaning, mathml, unit;
  int exponent = 0;                 ///< a number of that unit is 10^exponent in SI
  std::vector<std::size_t> places;  ///< among the problem's values
  std::vector<double> values;       ///< SI; of a frequency in Hz
  bool array = false, poisson = false, angular = false;

  /// The page shows a slider; its script reads what that moves.
  friend void fields(record::Fields& f, const ExploredRow& it) {
    const int reach = steps_a_decade * decades_each_way;
    f("name", it.name)("said", it.said)("meaning", it.meaning)
        .page("label", record::Markup{it.mathml});
    const bool auxetic = it.poisson && it.values.front() < usual_least_poisson;
    f("unit", it.unit);
    f.page("low", auxetic ? least_poisson : it.poisson ? usual_least_poisson : -reach);
    f.page("high", it.poisson ? most_poisson : reach);
    if (f.for_page()) return;
    f("exponent", it.exponent)("places", it.places)("values", it.values)("array", it.array);
    f("linear", it.poisson)("angular", it.angular);
  }
};

bool has_explorer(const Problem& problem) {
  return bool{rules::answer(rules::Question::report_explorer, problem)};
}

std::size_t place_among(const Problem& problem, const Symbol& symbol) {
  const Values& values = problem.values();
  const auto at =
      std::ranges::find_if(values, [&](const auto& pair) { return pair.first == symbol; });
  return static_cast<std::size_t>(std::distance(values.begin(), at));
}

/// As engineers write them: "N/µm", not "MN/m"; "0.1 µm", not "100 nm".
struct UsualUnit {
  const char* si;
  double from, to;  ///< sizes of numbers in SI
  const char* unit;
  int exponent;
};
constexpr std::array usual_units{UsualUnit{"N/m", 1e4, 1e11, "N/µm", 6},
                                 UsualUnit{"m", 1e-8, 1e-3, "µm", -6}};

void take_unit(ExploredRow& row, const std::string& unit, double value) {
  for (const UsualUnit& usual : usual_units)
    if (unit == usual.si && value >= usual.from && value < usual.to) {
      row.unit = usual.unit;
      row.exponent = usual.exponent;
      return;
    }
  const Scale scale = scale_for(value, unit);
  row.unit = scale.unit;
  row.exponent = -static_cast<int>(std::lround(std::log10(scale.factor)));
}

double typed_frequency(const Problem& problem, double omega) {
  return problem->frequency ? problem->frequency->value : omega / two_pi;
}

struct Called {
  std::string name, meaning;
  bool alone = true;  ///< no other number has this meaning
};

/// Quantities by their keys in the scene, which --set takes whatever the scene calls their symbols.
Called called(const Problem& problem, const ValueLine& line) {
  if (line.symbol == problem->angular_frequency.symbol) return {"frequency", "frequency"};
  if (line.symbol == problem->amplitude.symbol)
    return {"amplitude", problem->mount ? "amplitude of the vibrator" : "amplitude"};
  if (line.symbol == problem->indentation.symbol) return {"indentation", "indentation"};
  if (problem->load && line.symbol == problem->load->symbol) return {"force", "mean normal force"};
  if (line.symbol == problem->coefficient.symbol) return {"coefficient", line.meaning};
  if (problem->mount_mass && line.symbol == problem->mount_mass->symbol && !problem->mass)
    return {to_text(as_called(problem, line.symbol)), "moving mass"};
  if (problem->mass && line.symbol == problem->mass->symbol) return {"mass", "mass"};
  return {to_text(as_called(problem, line.symbol)), line.meaning, false};
}

ExploredRow row_of(const Problem& problem, const ValueLine& line) {
  const auto [name, meaning, alone] = called(problem, line);
  const Symbol shown = as_called(problem, line.symbol);
  ExploredRow row{.name = name,
                  .said = alone ? meaning : meaning + " " + name,
                  .meaning = meaning,
                  .mathml = shown == line.symbol ? line.name.mathml
                                                 : formula_of(symbolic::symbol(shown)).mathml,
                  .unit = "",
                  .places = {place_among(problem, line.symbol)},
                  .values = {line.value}};
  if (line.symbol == problem->angular_frequency.symbol) {
    row.values = {typed_frequency(problem, line.value)};
    row.mathml = formula_of(symbolic::symbol(Symbol{"f"})).mathml;
    row.angular = true;
    take_unit(row, "Hz", row.values.front());
  } else if (line.symbol.entry > 0) {
    row.name = as_called(problem, line.symbol).name;
    row.said = row.meaning = "all entries of " + row.name;
    row.mathml = "";
    row.unit = "×";
    row.array = true;
  } else {
    take_unit(row, line.unit, line.value);
  }
  return row;
}

void add_poisson(const Problem& problem, std::vector<ExploredRow>& rows) {
  const Isotropic* isotropic = given_ratio(problem);
  if (isotropic == nullptr) return;
  const Symbol& symbol = isotropic->quantity.symbol;
  const bool poisson = isotropic->by == Isotropic::By::poisson;
  const char* const meaning = poisson ? "Poisson's ratio" : "tangential over normal stiffness";
  rows.push_back({.name = poisson ? "poisson" : "tangential_ratio",
                  .said = meaning,
                  .meaning = meaning,
                  .mathml = poisson ? formula_of(symbolic::symbol(Symbol{"nu"})).mathml : "",
                  .unit = "",
                  .places = {place_among(problem, symbol)},
                  .values = {*isotropic->quantity.value},
                  .poisson = poisson});
}

std::vector<ExploredRow> rows_of(const Problem& problem) {
  std::vector<ExploredRow> rows;
  for (const ValueLine& line : value_lines(problem)) {
    ExploredRow row = row_of(problem, line);
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const ExploredRow& other) {
      return row.array && other.array && other.name == row.name;
    });
    if (same != rows.end()) {
      same->places.push_back(row.places.front());
      same->values.push_back(row.values.front());
    } else {
      rows.push_back(std::move(row));
    }
  }
  add_poisson(problem, rows);
  return rows;
}

std::size_t row_named(const std::vector<ExploredRow>& rows, const std::string& name) {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].name == name) return i;
  throw Bug("a quantity without a row");
}

record::Json data(const Problem& problem, const std::vector<ExploredRow>& rows) {
  return {{"file", problem->source->file},
          {"steps", steps_a_decade},
          {"scene", live::scene_text(problem)},
          {"amplitude", row_named(rows, "amplitude")},
          {"friction", row_named(rows, "coefficient")},
          {"separation", problem->separation},
          {"rows", record::json_of(rows)}};
}

std::string base64(std::string_view bytes) {
  std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
  base64_encode_raw(text.data(), bytes.size(),
                    reinterpret_cast<const unsigned char*>(bytes.data()));
  return text;
}

}  // namespace

record::Json explorer_record(const Problem& problem) {
  if (!has_explorer(problem)) return nullptr;
  const std::vector<ExploredRow> rows = rows_of(problem);
  const record::Markup content{json_for_page(data(problem, rows))}, module{base64(simulator())};
  const record::Fields page(record::Reader::page);
  return {{"rows", page.written(rows)},
          {"data", page.written(content)},
          {"module", page.written(module)}};
}

std::vector<std::string> explorer_scripts(const Problem& problem) {
  if (!has_explorer(problem)) return {};
  std::vector<std::string> all;
  for (const std::string_view script : explorer_scripts()) all.emplace_back(script);
  return all;
}

}  // namespace vcrit::validation::report
