#include <memory>
#include <string>

#include <fmt/format.h>

#include "mesh/file_extension.h"
#include "mesh/output_file.h"
#include "ucvt/error.h"
#include "ucvt/figure.h"

#ifdef UCVT_HAS_RSVG
#include <cairo.h>
#include <librsvg/rsvg.h>
#endif

namespace ucvt {
namespace {

#ifdef UCVT_HAS_RSVG

struct Release {
  void operator()(RsvgHandle* p) const { g_object_unref(p); }
  void operator()(GError* p) const { g_error_free(p); }
  void operator()(cairo_surface_t* p) const { cairo_surface_destroy(p); }
  void operator()(cairo_t* p) const { cairo_destroy(p); }
};

cairo_status_t append(void* to, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(to)->append(bytes, bytes + count);
  return CAIRO_STATUS_SUCCESS;
}

/// The picture at one pixel for each of its units.
std::string rendered(const std::string& svg) {
  GError* raw = nullptr;
  const auto fail = [&raw] {
    const std::unique_ptr<GError, Release> error(raw);
    throw NumericalError(fmt::format("librsvg does not render the figure: {}; write it as SVG",
                                     error ? error->message : "no reason given"));
  };
  const std::unique_ptr<GInputStream, void (*)(GInputStream*)> stream(
      g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr),
      [](GInputStream* s) { g_object_unref(s); });
  const std::unique_ptr<RsvgHandle, Release> handle(rsvg_handle_new_from_stream_sync(
      stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &raw));
  double width = 0, height = 0;
  if (!handle || rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height) == 0) {
    fail();
  }
  const std::unique_ptr<cairo_surface_t, Release> surface(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24, static_cast<int>(width), static_cast<int>(height)));
  const std::unique_ptr<cairo_t, Release> context(cairo_create(surface.get()));
  const RsvgRectangle all{0, 0, width, height};
  if (rsvg_handle_render_document(handle.get(), context.get(), &all, &raw) == 0) {
    fail();
  }
  std::string out;
  if (cairo_surface_write_to_png_stream(surface.get(), append, &out) != CAIRO_STATUS_SUCCESS) {
    fail();
  }
  return out;
}

#else

std::string rendered(const std::string& /*svg*/) {
  throw InvalidInput("this ucvt was built without librsvg, which PNG files need; write SVG");
}

#endif

}  // namespace

bool can_write_png() {
#ifdef UCVT_HAS_RSVG
  return true;
#else
  return false;
#endif
}

void write_figure(const std::string& path, const std::string& svg) {
  const std::string extension = file_extension(path);
  const bool png = extension == ".png";
  if (!png && extension != ".svg" && path != "-") {
    throw InvalidInput(
        fmt::format("the extension '{}' is none of a figure; write .svg or .png", extension));
  }
  const std::string bytes = png ? rendered(svg) : svg;
  OutputFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace ucvt
