// voluta-cad-reader step|iges CHORD ANGLE FILE: reads a CAD file with Open CASCADE and writes the
// facets of its bodies to standard output. CHORD [mm] is the largest distance of a facet from its
// surface, ANGLE [rad] the largest angle between neighbouring facets of one. Run by
// geometry/formats/cad_reader.cpp, which explains the output and the exit codes.
#include "cad_bodies.h"
#include "cad_facets.h"
#include "reader_limits.h"

#include <IFSelect_ReturnStatus.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <Standard_Failure.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFApp_Application.hxx>
#include <XSControl_WorkSession.hxx>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <unistd.h>

namespace {

using namespace voluta::cad_reader;
using Document = opencascade::handle<TDocStd_Document>;

constexpr rlim_t kMaxSeconds = 600;
// Repeated in geometry/formats/cad_reader.cpp.
enum Code { Read = 0, BadCall = 2, Damaged = 3, NothingToRead = 4, NoFaces = 5, NoMemory = 6 };

void put(std::FILE* out, const void* bytes, std::size_t count) {
  if (std::fwrite(bytes, 1, count, out) != count)
    std::_Exit(Damaged);
}

void putCount(std::FILE* out, std::uint64_t count) {
  put(out, &count, sizeof count);
}

void write(std::FILE* out, const std::vector<BodyFacets>& bodies, const Omitted& omitted) {
  put(out, "VCAD0001", 8);
  putCount(out, omitted.faces);
  putCount(out, omitted.curves);
  putCount(out, bodies.size());
  for (const BodyFacets& body : bodies) {
    putCount(out, body.name.size());
    put(out, body.name.data(), body.name.size());
    put(out, body.place.data(), sizeof body.place);
    putCount(out, body.corners.size() / 9);
    put(out, body.corners.data(), body.corners.size() * sizeof(double));
  }
  if (std::fflush(out) != 0)
    std::_Exit(Damaged);
}

// Lengths are converted to mm.
template <class Reader> Code readInto(Reader& reader, const char* file, Document document) {
  if (reader.ReadFile(file) != IFSelect_RetDone)
    return Damaged;
  reader.SetNameMode(true);
  reader.SetColorMode(false);
  reader.SetLayerMode(false);
  if (!reader.Transfer(document))
    return NothingToRead;
  return Read;
}

Code readFile(bool step, const char* file, Document document) {
  if (step) {
    STEPCAFControl_Reader reader;
    return readInto(reader, file, document);
  }
  IGESCAFControl_Reader reader;
  reader.SetReadVisible(true);
  return readInto(reader, file, document);
}

Code run(std::FILE* out, bool step, double chordMm, double angleRad, const char* file) {
  Document document;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
  if (const Code code = readFile(step, file, document); code != Read)
    return code;
  Omitted omitted;
  const std::vector<Body> bodies = bodiesOf(document, omitted);
  if (bodies.empty())
    return omitted.curves > 0 ? NoFaces : NothingToRead;
  std::vector<BodyFacets> facets;
  for (const Body& body : bodies)
    if (BodyFacets made = facetsOf(body, chordMm, angleRad, omitted); !made.corners.empty())
      facets.push_back(std::move(made));
  if (facets.empty())
    return Damaged;
  write(out, facets, omitted);
  return Read;
}

} // namespace

int main(int argc, char** argv) {
  if (argc != 5)
    return BadCall;
  const bool step = std::strcmp(argv[1], "step") == 0;
  const double chordMm = std::strtod(argv[2], nullptr), angleRad = std::strtod(argv[3], nullptr);
  if (!(chordMm > 0.0) || !(angleRad > 0.0))
    return BadCall;
  voluta::limitReader(kMaxSeconds);
  // Open CASCADE reports to standard output.
  std::FILE* out = fdopen(dup(STDOUT_FILENO), "wb");
  if (!out || dup2(STDERR_FILENO, STDOUT_FILENO) < 0)
    return BadCall;
  Message::DefaultMessenger()->ChangePrinters().Clear();
  int code = Damaged;
  try {
    code = run(out, step, chordMm, angleRad, argv[4]);
  } catch (const std::bad_alloc&) {
    code = NoMemory;
  } catch (const Standard_Failure& failure) {
    code = std::strcmp(failure.DynamicType()->Name(), "Standard_OutOfMemory") == 0 ? NoMemory
                                                                                   : Damaged;
  } catch (const std::exception&) {
  }
  std::_Exit(code); // The kernel takes long to free a large model
}
