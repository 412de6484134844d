#include "design/places.hpp"

#include <algorithm>
#include <cmath>

namespace vcrit::design {

std::vector<double> even(double a, double b, int samples) {
  std::vector<double> places;
  for (int i = 0; i < samples; ++i)
    places.push_back(i + 1 == samples ? b : a + (b - a) * i / (samples - 1));
  return places;
}

std::vector<double> even_ratios(double a, double b, int samples) {
  std::vector<double> places = even(std::log(a), std::log(b), samples);
  for (double& place : places) place = std::clamp(std::exp(place), std::min(a, b), std::max(a, b));
  places.front() = a, places.back() = b;
  return places;
}

}  // namespace vcrit::design
