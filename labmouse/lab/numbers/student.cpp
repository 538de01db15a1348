#include "labmouse/lab/numbers/student.hpp"

#include <array>
#include <cassert>
#include <cstddef>

namespace labmouse {

double student_quantile(int freedom) {
  constexpr std::array table = {12.706204736175, 4.302652729749, 3.182446305284, 2.776445105198, 2.570581835636,
                                2.446911851145,  2.364624251593, 2.306004135204, 2.262157162799, 2.228138851986,
                                2.200985160091,  2.178812829667, 2.160368656463, 2.144786687918, 2.131449545560,
                                2.119905299222,  2.109815577833, 2.100922040241, 2.093024054408, 2.085963447266};
  assert(freedom >= 1);
  const auto place = static_cast<std::size_t>(freedom) - 1;
  if (place < table.size()) return table[place];
  // Expansion about the normal quantile z in powers of 1 / freedom (Abramowitz and Stegun 1964, 26.7.5).
  constexpr double z = 1.959963984540054, z2 = z * z;
  constexpr double first = z * (z2 + 1) / 4, second = z * ((5 * z2 + 16) * z2 + 3) / 96,
                   third = z * (((3 * z2 + 19) * z2 + 17) * z2 - 15) / 384,
                   fourth = z * ((((79 * z2 + 776) * z2 + 1482) * z2 - 1920) * z2 - 945) / 92160;
  const double part = 1.0 / freedom;
  return z + part * (first + part * (second + part * (third + part * fourth)));
}

}  // namespace labmouse
