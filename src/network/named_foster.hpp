// The Foster form of a stiffness K(s) whose coefficients have names: its elements are quotients of
// polynomials in them.
#pragma once

#include <string>
#include <variant>

#include "network/foster.hpp"
#include "network/polynomial.hpp"

namespace vcrit {

/// As foster_form(), for a K(s) in the polynomials' variable `s`. Elements of numbers alone are
/// `values`, others `expressions`. There is one only where the poles are quotients of the names and
/// every element is above 0 wherever the names are: its polynomials have terms of one sign. Where
/// this does not hold of K(s) it may of 1/K(s): then the form is springs, dampers and Kelvin
/// elements one behind the other, k0_name, c0_name, k_name[j] with c_name[j]. What neither form
/// shows to be passive is refused, with the reason of the first.
std::variant<FosterForm, NoFosterForm> named_foster_form(const PolynomialQuotient& stiffness,
                                                         const std::string& s,
                                                         const std::string& name);

}  // namespace vcrit
