// The natural logarithm, the same to the bit on every machine, which the C library does not
// promise.
#pragma once

namespace winnow {

double natural_logarithm(
    double value);  // of a positive, normal number; relative error below 10^-14

// e to the power of `value`, likewise; relative error below 10^-8 for values from -15 to 15.
double exponential(double value);

}  // namespace winnow
