#include "program.hpp"
namespace winnow::cli { void add_info(CLI::App&) {} }
