#include "scene/written_digits.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace vcrit {

namespace {

// "0.0123e4": three digits, of which the last one stands for 10^0.
struct Written {
  int digits = 0, last = 0;
};

Written written(const std::string& number) {
  Written result;
  bool point = false;
  for (std::size_t i = 0; i < number.size(); ++i) {
    const char c = number[i];
    if (c == 'e' || c == 'E') {
      result.last += std::atoi(number.c_str() + i + 1);
      break;
    }
    if (c == '.') point = true;
    if (std::isdigit(static_cast<unsigned char>(c)) == 0) continue;
    if (point) --result.last;
    if (c != '0' || result.digits > 0) ++result.digits;
  }
  return result;
}

}  // namespace

std::vector<double> rounding_steps(const std::vector<std::string>& numbers) {
  int finest = std::numeric_limits<int>::max(), most = 0;
  for (const std::string& number : numbers) {
    const Written found = written(number);
    finest = std::min(finest, found.last);
    most = std::max(most, found.digits);
  }
  std::vector<double> steps;
  for (const std::string& number : numbers) {
    const Written found = written(number);
    const int by_digits = found.last + found.digits - most;
    steps.push_back(std::pow(10.0, found.digits > 0 ? std::max(finest, by_digits) : finest));
  }
  return steps;
}

}  // namespace vcrit
