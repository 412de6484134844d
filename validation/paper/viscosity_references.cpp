// tests/data/paper_viscosity.csv and paper_crossings.csv, compiled in: Newton's method on the
// events of the full motion, with 40 digits, by a script that shares nothing with this program.
#include <limits>

#include "paper/references.hpp"

namespace vcrit::validation::paper {

std::span<const ViscosityReference> viscosity_references() {
  static constexpr std::array rows{ViscosityReference{0, 0.01, 0.97090384025247},
                                   ViscosityReference{0.1, 0.01, 0.96681123971452},
                                   ViscosityReference{0.3, 0.01, 0.952121813535494},
                                   ViscosityReference{1, 0.01, 0.923460997133702},
                                   ViscosityReference{2, 0.01, 0.91257299428953},
                                   ViscosityReference{10, 0.01, 0.907076011406338},
                                   ViscosityReference{100, 0.01, 0.906813168571138},
                                   ViscosityReference{0, 0.05, 0.868405388092294},
                                   ViscosityReference{0.1, 0.05, 0.864726033964092},
                                   ViscosityReference{0.3, 0.05, 0.84301119025037},
                                   ViscosityReference{1, 0.05, 0.78552423055079},
                                   ViscosityReference{2, 0.05, 0.762529081348201},
                                   ViscosityReference{10, 0.05, 0.750917389223134},
                                   ViscosityReference{100, 0.05, 0.750362840093945},
                                   ViscosityReference{0, 0.1, 0.75717136015313},
                                   ViscosityReference{0.1, 0.1, 0.754210412861147},
                                   ViscosityReference{0.3, 0.1, 0.734217567758948},
                                   ViscosityReference{1, 0.1, 0.669337641481242},
                                   ViscosityReference{2, 0.1, 0.641957868812278},
                                   ViscosityReference{10, 0.1, 0.628079735538233},
                                   ViscosityReference{100, 0.1, 0.627416898366813},
                                   ViscosityReference{0, 0.3, 0.420641852599251},
                                   ViscosityReference{0.1, 0.3, 0.419534809279115},
                                   ViscosityReference{0.3, 0.3, 0.411092570243134},
                                   ViscosityReference{1, 0.3, 0.36972472350713},
                                   ViscosityReference{2, 0.3, 0.348622134475931},
                                   ViscosityReference{10, 0.3, 0.337592512263639},
                                   ViscosityReference{100, 0.3, 0.337062321915675},
                                   ViscosityReference{0, 0.5, 0.201452203333669},
                                   ViscosityReference{0.1, 0.5, 0.201302065063373},
                                   ViscosityReference{0.3, 0.5, 0.199624270908876},
                                   ViscosityReference{1, 0.5, 0.185848281037013},
                                   ViscosityReference{2, 0.5, 0.176701506748955},
                                   ViscosityReference{10, 0.5, 0.171579352458654},
                                   ViscosityReference{100, 0.5, 0.17132839106127},
                                   ViscosityReference{0, 0.6, 0.125473318103038},
                                   ViscosityReference{0.1, 0.6, 0.125572944702756},
                                   ViscosityReference{0.3, 0.6, 0.125684707981512},
                                   ViscosityReference{1, 0.6, 0.120896368391339},
                                   ViscosityReference{2, 0.6, 0.11640753028001},
                                   ViscosityReference{10, 0.6, 0.113684914910787},
                                   ViscosityReference{100, 0.6, 0.113548501992681},
                                   ViscosityReference{0, 0.7, 0.0688335483643268},
                                   ViscosityReference{0.1, 0.7, 0.0690578924656596},
                                   ViscosityReference{0.3, 0.7, 0.0700920970696701},
                                   ViscosityReference{1, 0.7, 0.0707208603844835},
                                   ViscosityReference{2, 0.7, 0.0694631128741008},
                                   ViscosityReference{10, 0.7, 0.068481959336392},
                                   ViscosityReference{100, 0.7, 0.0684297616229932},
                                   ViscosityReference{0, 0.8, 0.0298884265606293},
                                   ViscosityReference{0.1, 0.8, 0.0301268418980665},
                                   ViscosityReference{0.3, 0.8, 0.0313352867702231},
                                   ViscosityReference{1, 0.8, 0.0340454224628964},
                                   ViscosityReference{2, 0.8, 0.0344776148918941},
                                   ViscosityReference{10, 0.8, 0.034495641996702},
                                   ViscosityReference{100, 0.8, 0.0344930990821897},
                                   ViscosityReference{0, 0.9, 0.00731081033452821},
                                   ViscosityReference{0.1, 0.9, 0.00746558663945053},
                                   ViscosityReference{0.3, 0.9, 0.00822665361324955},
                                   ViscosityReference{1, 0.9, 0.0102333987979422},
                                   ViscosityReference{2, 0.9, 0.0109017110508384},
                                   ViscosityReference{10, 0.9, 0.0111776961667679},
                                   ViscosityReference{100, 0.9, 0.0111897021746989},
                                   ViscosityReference{0, 0.99, 7.17634985068637e-5},
                                   ViscosityReference{0.1, 0.99, 8.5428162793706e-5},
                                   ViscosityReference{0.3, 0.99, 0.000132633734776273},
                                   ViscosityReference{1, 0.99, 0.000243893121655311},
                                   ViscosityReference{2, 0.99, 0.000290048032409256},
                                   ViscosityReference{10, 0.99, 0.000313413635488339},
                                   ViscosityReference{100, 0.99, 0.000314526466486849}};
  return rows;
}

std::span<const CrossingReference> crossing_references() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  static constexpr std::array rows{
      CrossingReference{0, 0.53702927214631507685, 0, 0},
      CrossingReference{0.3, 0.58667281925458815936, 0.0253987533075183, 0.00147331580218442},
      CrossingReference{1, 0.66283281945158694912, 0.0881063478264008, 0.00417594785344955},
      CrossingReference{2, 0.69101565393071027095, 0.115223169850909, 0.00475875383761839},
      CrossingReference{10, 0.70440500563801763883, 0.129100205101882, 0.00493129613822623},
      CrossingReference{100, 0.70502990820727218009, 0.129764729703675, 0.00493763309861179},
      CrossingReference{infinity, 0.70503625429397418574, 0.129771486051611, 0.00493769666110886}};
  return rows;
}

}  // namespace vcrit::validation::paper
