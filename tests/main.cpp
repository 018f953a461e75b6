// Catch's own main: see base_tests --help.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
