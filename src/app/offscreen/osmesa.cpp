#include "app/offscreen/context.hpp"
#include "core/error.hpp"

#include <GL/osmesa.h>

namespace steplab {
namespace {

// OSMesa wants a picture of its own; everything is drawn into framebuffer objects, so this one is never seen.
unsigned char unseen[4];

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
    if (!context) throw GraphicsError("OSMesa offers no OpenGL 3.3 core context");
    context_ = context;
    if (OSMesaMakeCurrent(context, unseen, GL_UNSIGNED_BYTE, 1, 1)) return;
    OSMesaDestroyContext(context);
    throw GraphicsError("OSMesa's context cannot be made current");
}

OffscreenContext::~OffscreenContext() { OSMesaDestroyContext(static_cast<OSMesaContext>(context_)); }

}  // namespace steplab

// GLEW as Debian builds it asks GLX for OpenGL's functions; there is no GLX here.
extern "C" {
void (*glXGetProcAddressARB(const GLubyte* name))() {
    return OSMesaGetProcAddress(reinterpret_cast<const char*>(name));
}
const char* glXGetClientString(void*, int) { return nullptr; }
int glXQueryVersion(void*, int*, int*) { return 0; }
}
