// An independent way to Eq. 24: nodal analysis at many digits. Shares nothing with the reduction
// but the network's data structure.
#pragma once

#include <complex>
#include <memory>
#include <string>
#include <utility>

#include "network/network.hpp"
#include "scene/scene.hpp"

namespace vcrit::test {

/// A number of 250 digits. Nodal elimination subtracts, so that networks over D decades lose up to
/// some multiples of D digits; 250 leave at least 50 good ones for everything the tests draw (at
/// most 12 elements over 12 decades each way). Its arithmetic is compiled in nodal.cpp alone, as
/// the header that it is from takes the compiler two seconds.
class Real {
 public:
  struct Digits;

  Real(double value = 0);
  explicit Real(const std::string& decimal);
  explicit Real(std::shared_ptr<const Digits> digits) : digits_(std::move(digits)) {}
  explicit operator double() const;
  const Digits& digits() const { return *digits_; }
  std::string str(int figures) const;  ///< with an exponent

 private:
  std::shared_ptr<const Digits> digits_;
};

Real operator-(const Real& a);
Real operator+(const Real& a, const Real& b);
Real operator-(const Real& a, const Real& b);
Real operator*(const Real& a, const Real& b);
Real operator/(const Real& a, const Real& b);
Real& operator+=(Real& a, const Real& b);
bool operator<(const Real& a, const Real& b);
bool operator<=(const Real& a, const Real& b);
bool operator>(const Real& a, const Real& b);
bool isfinite(const Real& a);
Real abs(const Real& a);
Real sqrt(const Real& a);
Real atan2(const Real& y, const Real& x);
Real ldexp(const Real& a, int exponent);

class Complex {
 public:
  Complex(Real real = 0, Real imag = 0) : real_(std::move(real)), imag_(std::move(imag)) {}
  const Real& real() const { return real_; }
  const Real& imag() const { return imag_; }

 private:
  Real real_, imag_;
};

Complex operator-(const Complex& a);
Complex operator+(const Complex& a, const Complex& b);
Complex operator-(const Complex& a, const Complex& b);
Complex operator*(const Complex& a, const Complex& b);
Complex operator/(const Complex& a, const Complex& b);
Complex& operator+=(Complex& a, const Complex& b);
Complex& operator-=(Complex& a, const Complex& b);
Real abs(const Complex& a);

/// The admittance matrix of the network's elements, each series part with inner nodes of its own.
class Nodal {
 public:
  Nodal(const Values& values, const Real& omega) : values_(values), omega_(omega) {}

  Complex stiffness(const Network& network) const;

 private:
  const Values& values_;
  Real omega_;
};

/// |value - exact|/|exact|
double relative_error(std::complex<double> value, const Complex& exact);
double relative_error(double value, const Real& exact);

/// Eq. 24 as printed in the paper, at many digits.
Real critical_velocity_by_nodes(const Scene& scene);

}  // namespace vcrit::test
