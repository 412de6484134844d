// Of matrices: what is compiled of Eigen's decompositions, here and nowhere else, since each takes
// a compiler seconds and a file that includes <Eigen/Dense> pays them again. <Eigen/Core> is enough
// elsewhere.
#pragma once

#include <Eigen/Core>

namespace vcrit::linear {

template <class Number>
using DenseMatrix = Eigen::Matrix<Number, Eigen::Dynamic, Eigen::Dynamic>;
template <class Number>
using DenseVector = Eigen::Matrix<Number, Eigen::Dynamic, 1>;

}  // namespace vcrit::linear
