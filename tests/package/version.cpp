// Compiles if the header has the same version as the build system that found it, EXPECTED.
#include "ribbon/version.h"

#include <string_view>

#if RIBBON_VERSION_MAJOR < 0 || RIBBON_VERSION_MINOR < 0 || RIBBON_VERSION_PATCH < 0
#error "these are no numbers"
#endif

#define TEXT_OF(number) #number
#define TEXT(number) TEXT_OF(number)
#define NUMBERS TEXT(RIBBON_VERSION_MAJOR) "." TEXT(RIBBON_VERSION_MINOR) "." TEXT(RIBBON_VERSION_PATCH)

static_assert(std::string_view(RIBBON_VERSION) == EXPECTED);
static_assert(std::string_view(NUMBERS) == EXPECTED);
