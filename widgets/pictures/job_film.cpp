#include "pictures/job_film.h"

#include "base/error.h"
#include "pictures/film_writer.h"
#include "pictures/job_renderer.h"
#include "scene/drawing_thread.h"

#include <algorithm>
#include <cmath>

namespace voluta::pictures {

void writeFilm(const project::Job& job, const FilmOptions& options,
               const std::filesystem::path& file, const base::RunContext& ctx) {
  if (!(options.lengthS >= kFilmLengthMinS && options.lengthS <= kFilmLengthMaxS))
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("a film of {length} cannot be made"_text, base::seconds(options.lengthS)), {},
        base::message("give {least} to {most}"_text, base::seconds(kFilmLengthMinS),
                      base::seconds(kFilmLengthMaxS)));
  PictureOptions look = options.look;
  look.layer.reset();
  look.timeS.reset();
  look.width -= look.width % 2;
  look.height -= look.height % 2;
  const scene::StandardView view = standardViewOf(look.view);
  scene::inDrawingThread([&] {
    Renderer renderer(look, job);
    renderer.showRobot();
    scene::OffscreenTarget target;
    scene::OffscreenTarget::Session session(target, renderer.scene(), look.width, look.height);
    renderer.scene().standardView(view);
    FilmWriter film(file, look.width, look.height, options.framesPerS);
    const int frames =
        std::max(2, static_cast<int>(std::lround(options.lengthS * options.framesPerS)));
    for (int i = 0; i < frames; ++i) {
      const double share = static_cast<double>(i) / (frames - 1);
      ctx.report(share, "drawing the film"_text);
      ctx.checkpoint();
      renderer.setTime(share * renderer.durationS());
      session.draw();
      film.add(session.image());
    }
    film.finish();
  });
}

} // namespace voluta::pictures
