#include "critical/columns.hpp"

#include <fmt/core.h>

#include "base/errors.hpp"

namespace vcrit {

void check_columns(const std::vector<std::string>& names,
                   std::span<const std::span<const double>> columns, std::size_t values) {
  if (columns.size() != names.size())
    throw InputError({"columns"}, fmt::format("{} of them", columns.size()),
                     fmt::format("{}, one for each varying parameter", names.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].size() != 1 && columns[i].size() != values)
      throw InputError({names[i]}, fmt::format("{} values", columns[i].size()),
                       fmt::format("{} as in out, or one for all", values));
}

}  // namespace vcrit
