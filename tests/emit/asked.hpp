// What a driver asks of each library: gradients take compilers more than all else.
#pragma once

namespace vcrit::test {

enum class Asked { values, values_and_gradients };

}  // namespace vcrit::test
