#include "app/window/keys.hpp"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstring>
#include <iterator>

namespace steplab {
namespace {

using ui::Key;

struct Pair {
    int glfw;
    Key key;
    char printed = 0;
};

constexpr Pair pairs[] = {
    {GLFW_KEY_SPACE, Key::space},
    {GLFW_KEY_LEFT, Key::left},
    {GLFW_KEY_RIGHT, Key::right},
    {GLFW_KEY_UP, Key::up},
    {GLFW_KEY_DOWN, Key::down},
    {GLFW_KEY_BACKSPACE, Key::backspace},
    {GLFW_KEY_DELETE, Key::del},
    {GLFW_KEY_HOME, Key::home},
    {GLFW_KEY_END, Key::end},
    {GLFW_KEY_TAB, Key::tab},
    {GLFW_KEY_ENTER, Key::enter},
    {GLFW_KEY_KP_ENTER, Key::enter},
    {GLFW_KEY_ESCAPE, Key::escape},
    {GLFW_KEY_F1, Key::f1},
    {GLFW_KEY_F11, Key::f11},
    {GLFW_KEY_F6, Key::f6},
    {GLFW_KEY_PAGE_UP, Key::page_up},
    {GLFW_KEY_PAGE_DOWN, Key::page_down},
    {GLFW_KEY_KP_ADD, Key::equal},
    {GLFW_KEY_KP_SUBTRACT, Key::minus},
    {GLFW_KEY_F, Key::f, 'f'},
    {GLFW_KEY_P, Key::p, 'p'},
    {GLFW_KEY_Q, Key::q, 'q'},
    {GLFW_KEY_A, Key::a, 'a'},
    {GLFW_KEY_O, Key::o, 'o'},
    {GLFW_KEY_S, Key::s, 's'},
    {GLFW_KEY_C, Key::c, 'c'},
    {GLFW_KEY_V, Key::v, 'v'},
    {GLFW_KEY_X, Key::x, 'x'},
    {GLFW_KEY_Z, Key::z, 'z'},
    {GLFW_KEY_B, Key::b, 'b'},
    {GLFW_KEY_R, Key::r, 'r'},
    {GLFW_KEY_T, Key::t, 't'},
    {GLFW_KEY_Y, Key::y, 'y'},
    {GLFW_KEY_J, Key::j, 'j'},
    {GLFW_KEY_L, Key::l, 'l'},
    {GLFW_KEY_N, Key::n, 'n'},
    {GLFW_KEY_0, Key::zero, '0'},
    {GLFW_KEY_KP_0, Key::zero},
    {GLFW_KEY_EQUAL, Key::equal, '='},
    {GLFW_KEY_EQUAL, Key::equal, '+'},
    {GLFW_KEY_MINUS, Key::minus, '-'},
    {GLFW_KEY_LEFT_BRACKET, Key::bracket_left, '['},
    {GLFW_KEY_RIGHT_BRACKET, Key::bracket_right, ']'},
};

template <class Is>
Key find_key(Is is) {
    const auto* found = std::find_if(std::begin(pairs), std::end(pairs), is);
    return found == std::end(pairs) ? Key::none : found->key;
}

bool is_letter(char c) { return c >= 'a' && c <= 'z'; }

}  // namespace

ui::Key key_of(int glfw_key, int scancode) {
    const char* name = glfwGetKeyName(glfw_key, scancode);
    const char printed = name && std::strlen(name) == 1 ? name[0] : '\0';
    const Key by_print = printed ? find_key([&](const Pair& pair) { return pair.printed == printed; }) : Key::none;
    if (by_print != Key::none || is_letter(printed)) return by_print;
    return find_key([&](const Pair& pair) { return pair.glfw == glfw_key; });
}

}  // namespace steplab
