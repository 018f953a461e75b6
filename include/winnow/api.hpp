// Marks what the shared library shows; everything else in it is hidden.
#pragma once

#define WINNOW_API __attribute__((visibility("default")))
#define WINNOW_LOCAL __attribute__((visibility("hidden")))  // a part of a class that it shows
