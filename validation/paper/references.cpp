#include "paper/references.hpp"

namespace vcrit::validation::paper {

std::span<const FrictionValue> friction_references() {
  static constexpr std::array rows{FrictionValue{1, 0.1, 0.39759612266688192354},
                                   FrictionValue{1, 0.3, 0.66724774884358300890},
                                   FrictionValue{1, 0.5, 0.83273654706668832509},
                                   FrictionValue{1, 0.7, 0.93635122565396488427},
                                   FrictionValue{1, 0.9, 0.99078994108185206441},
                                   FrictionValue{1, 0.99, 0.99978049619051021994},
                                   FrictionValue{2, 0.1, 0.42223791806894940554},
                                   FrictionValue{2, 0.3, 0.68624007897166206641},
                                   FrictionValue{2, 0.5, 0.84096864392594018151},
                                   FrictionValue{2, 0.7, 0.93748319841330928917},
                                   FrictionValue{2, 0.9, 0.99018846005424541663},
                                   FrictionValue{2, 0.99, 0.99973895677083166977},
                                   FrictionValue{10, 0.1, 0.43472823801559018329},
                                   FrictionValue{10, 0.3, 0.69616673896272459756},
                                   FrictionValue{10, 0.5, 0.84557858278721111304},
                                   FrictionValue{10, 0.7, 0.93836623659724717461},
                                   FrictionValue{10, 0.9, 0.98994007344990892285},
                                   FrictionValue{10, 0.99, 0.99971792772806049478},
                                   FrictionValue{100, 0.1, 0.43532479146986868919},
                                   FrictionValue{100, 0.3, 0.69664391027589286956},
                                   FrictionValue{100, 0.5, 0.84580444804485728077},
                                   FrictionValue{100, 0.7, 0.93841321453930614408},
                                   FrictionValue{100, 0.9, 0.98992926804277097528},
                                   FrictionValue{100, 0.99, 0.99971692618016183573}};
  return rows;
}

std::span<const FrictionValue> elastic_references() {
  static constexpr std::array rows{FrictionValue{0, 0.1, 0.3185457758621830509527},
                                   FrictionValue{0, 0.5, 0.8186930169996981800837}};
  return rows;
}

std::span<const FrictionValue> reduced_references() {
  static constexpr std::array rows{
      FrictionValue{0, 0.1, 0.31854577586218},  FrictionValue{0, 0.5, 0.81869301699970},
      FrictionValue{1, 0.1, 0.4642607132736},   FrictionValue{1, 0.5, 0.8367398045185},
      FrictionValue{10, 0.1, 0.7207052919138},  FrictionValue{10, 0.5, 0.8917875223416},
      FrictionValue{100, 0.1, 0.7535068053240}, FrictionValue{100, 0.5, 0.9008758004292}};
  return rows;
}

std::span<const RestReference> rest_references() {
  static constexpr std::array rows{
      RestReference{1, 0.2445908350708}, RestReference{2, 0.4256867845968},
      RestReference{10, 0.6303611587529}, RestReference{100, 0.6766744497619}};
  return rows;
}

std::span<const PunchReference> punch_references() {
  static constexpr std::array rows{PunchReference{0.001, 0.99693266303416232517},
                                   PunchReference{0.1, 0.75717136015312994339},
                                   PunchReference{0.25, 0.4918816026829403061},
                                   PunchReference{0.5, 0.2014522033336686888},
                                   PunchReference{0.75, 0.047238266278833194827},
                                   PunchReference{0.9, 0.0073108103345282100357},
                                   PunchReference{0.99, 0.000071763498506863749421}};
  return rows;
}

std::span<const PrintedLimit> printed_limits() {
  static constexpr std::array rows{PrintedLimit{1, 0.71, 0.005}, PrintedLimit{2, 0.45, 0.005},
                                   PrintedLimit{10, 0.1, 0.05}, PrintedLimit{100, 0.01, 0.005}};
  return rows;
}

}  // namespace vcrit::validation::paper
