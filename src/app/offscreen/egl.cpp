#include <EGL/egl.h>

// GLEW in Debian loads OpenGL's functions through GLX, which is not available here.
extern "C" {
void (*glXGetProcAddressARB(const unsigned char* name))() {
    return eglGetProcAddress(reinterpret_cast<const char*>(name));
}
const char* glXGetClientString(void*, int) { return nullptr; }
int glXQueryVersion(void*, int*, int*) { return 0; }
}
