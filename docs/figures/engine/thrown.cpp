// Debian's C++ library for WebAssembly has no exceptions: what is thrown ends the call, with its
// message, by an exception of the page's JavaScript.
#include "common/system/input_error.hpp"

#include <cstdlib>
#include <cstring>
#include <string_view>
#include <typeinfo>

extern "C" {

/// Throws in JavaScript.
[[noreturn, clang::import_module("page"), clang::import_name("thrown")]] void page_thrown(
    const char* message, std::size_t size);

void* __cxa_allocate_exception(std::size_t size) {
    return std::malloc(size);
}

void __cxa_throw(void* thrown, void* type, void (* /*destroy*/)(void*)) {
    std::string_view message = "the engine has ended";
    if (*static_cast<const std::type_info*>(type) == typeid(rt::InputError))
        message = static_cast<const rt::InputError*>(thrown)->what();
    page_thrown(message.data(), message.size());
}
}
