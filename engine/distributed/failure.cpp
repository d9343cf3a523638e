// SPDX-License-Identifier: GPL-2.0-only
/// Exceptions as bytes.
#include "engine/distributed/failure.hpp"

#include "engine/errors.hpp"

namespace scarp::distributed {
namespace {

enum class Kind { unstable, scene, file, checkpoint, stopped, other };

void put_instability(Message& message, const Instability& what) {
  message.put(what.step);
  message.put(what.time);
  message.put(std::string_view(what.stage));
  message.put(what.particle);
  message.put(what.position);
  message.put(std::string_view(what.field));
  message.put(std::string_view(what.unit));
  message.put(what.value);
  message.put(what.limit);
  message.put(std::string_view(what.cause));
  message.put(std::string_view(what.advice));
}

Instability take_instability(Message& message) {
  Instability what;
  what.step = message.take<std::uint64_t>();
  what.time = message.take<double>();
  what.stage = message.take_text();
  what.particle = message.take<std::int64_t>();
  what.position = message.take<std::array<double, 3>>();
  what.field = message.take_text();
  what.unit = message.take_text();
  what.value = message.take<double>();
  what.limit = message.take<double>();
  what.cause = message.take_text();
  what.advice = message.take_text();
  return what;
}

}  // namespace

Message failure_message(const std::exception_ptr& thrown) {
  Message message;
  if (!thrown) return message;
  const auto put = [&](Kind kind) {
    message.put(kind);
    message.put(std::string_view(reason_of(thrown)));
  };
  try {
    std::rethrow_exception(thrown);
  } catch (const SimulationInstability& error) {
    put(Kind::unstable);
    message.put(static_cast<int>(error.what_happened().has_value()));
    if (error.what_happened()) put_instability(message, *error.what_happened());
  } catch (const SceneError&) {
    put(Kind::scene);
  } catch (const FileError&) {
    put(Kind::file);
  } catch (const CheckpointError&) {
    put(Kind::checkpoint);
  } catch (const Stopped&) {
    put(Kind::stopped);
  } catch (...) {
    put(Kind::other);
  }
  return message;
}

void throw_failure(Message message) {
  const auto kind = message.take<Kind>();
  const std::string words = message.take_text();
  switch (kind) {
    case Kind::unstable:
      if (message.take<int>() != 0) throw SimulationInstability(take_instability(message));
      throw SimulationInstability(words);
    case Kind::scene:
      throw SceneError(words);
    case Kind::file:
      throw FileError(words);
    case Kind::checkpoint:
      throw CheckpointError(words);
    case Kind::stopped:
      throw Stopped();
    case Kind::other:
      break;
  }
  throw Error(words);
}

}  // namespace scarp::distributed
