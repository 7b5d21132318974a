// Debian's C++ library for WebAssembly has no exceptions: who throws ends the module. Figures send
// no malformed question.
#include <cstdlib>

extern "C" void* __cxa_allocate_exception(std::size_t /*size*/) {
    std::abort();
}
extern "C" void __cxa_throw(void* /*thrown*/, void* /*type*/, void (* /*destroy*/)(void*)) {
    std::abort();
}
