#include "app/offscreen/context.hpp"
#include "core/error.hpp"

#include <GL/osmesa.h>

namespace steplab {
namespace {

// OSMesa requires a buffer. Everything is drawn into framebuffer objects, so this one is not used.
unsigned char unused[4];

}  // namespace

OffscreenContext::OffscreenContext() {
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_DEPTH_BITS,
                              0,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    const OSMesaContext context = OSMesaCreateContextAttribs(attributes, nullptr);
    if (!context) throw GraphicsError("OSMesa cannot create an OpenGL 3.3 core context");
    context_ = context;
    if (OSMesaMakeCurrent(context, unused, GL_UNSIGNED_BYTE, 1, 1)) return;
    OSMesaDestroyContext(context);
    throw GraphicsError("OSMesa cannot make its context current");
}

OffscreenContext::~OffscreenContext() { OSMesaDestroyContext(static_cast<OSMesaContext>(context_)); }

}  // namespace steplab

// GLEW in Debian loads OpenGL's functions through GLX, which is not available here.
extern "C" {
void (*glXGetProcAddressARB(const GLubyte* name))() {
    return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
}
const char* glXGetClientString(void*, int) { return nullptr; }
int glXQueryVersion(void*, int*, int*) { return 0; }
}
