# SPDX-License-Identifier: BSD-3-Clause
"""Steps and runs against the program, views and their end, threads, Ctrl-C, checkpoints, soil models of numpy.

usage: simulation_test.py PROGRAM
"""
import os
import signal
import threading
import time
import unittest

import common
import numpy as np
import scarp
from common import CLAY, column


def simulation(scene=None, **options):
    return scarp.Simulation(scene or column(), threads=1, **options)


class RunTest(common.TestCase):
    def test_a_run_leaves_the_files_of_the_program(self):
        self.program(column(), "run", "-q", "--threads", 1, "-o", self.folder / "program")
        mine = simulation(scarp.Scene.from_toml(self.folder / "scene.toml"))
        mine.run(folder=self.folder / "python")
        names = sorted(path.relative_to(self.folder / "program") for path in (self.folder / "program").rglob("*")
                       if path.suffix in (".hdf", ".csv", ".series", ".toml"))
        self.assertGreater(len(names), 8)
        for name in names:
            if name.name == "history.csv":  # its last column is the wall time
                continue
            self.assertEqual((self.folder / "python" / name).read_bytes(),
                             (self.folder / "program" / name).read_bytes(), name)
        frames = scarp.read_frames(self.folder / "python")
        self.assertEqual(frames[-1].time, np.float64(mine.time))
        self.assert_same(frames[-1].fields["stress"], mine.field("stress").astype(np.float32))
        self.assertIn("accumulated_plastic_strain", frames[-1].table())
        probes = scarp.read_table(self.folder / "python", "probes")
        # Tables have ten digits.
        self.assertAlmostEqual(probes["crest.position_x"][-1], mine.probe("crest").position[0], delta=1e-10)
        with self.assertRaisesRegex(scarp.FileError, "overwrite"):
            simulation().run(folder=self.folder / "python")

    def test_a_run_that_ctrl_c_stopped_goes_on_as_if_it_had_not(self):
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        scene = column(stage=dict(name="spread", duration="0.4 s"))
        whole, stopped = simulation(scene), simulation(scene)
        whole.run(folder=self.folder / "whole")

        def stop(now):
            if now.time >= 0.1:
                signal.raise_signal(signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            stopped.run(folder=self.folder / "stopped", callback=stop)
        self.assertLess(stopped.time, 0.2)
        again = scarp.Simulation.resume_run(self.folder / "stopped", threads=1)
        self.assertEqual(again.scene.title, "Column")
        with self.assertRaisesRegex(scarp.FileError, "another|lock|use"):
            scarp.Simulation.resume_run(self.folder / "stopped")
        again.run()
        self.assert_same(again.field("stress"), whole.field("stress"))
        for name in ("probes.csv", "frames/soil.hdf.series", "frames/soil_00003.hdf"):
            self.assertEqual((self.folder / "stopped" / name).read_bytes(), (self.folder / "whole" / name).read_bytes(), name)
        with self.assertRaisesRegex(scarp.Error, "complete"):
            scarp.Simulation.resume_run(self.folder / "stopped")
        with self.assertRaises(scarp.FileError):
            scarp.Simulation.resume_run(self.folder / "nothing")

    def test_steps_a_run_and_a_run_in_parts_are_the_same(self):
        whole, parts, steps = simulation(), simulation(), simulation(oversubscribe=True)
        whole.run()
        parts.run(until="50 ms", folder=self.folder / "parts")
        self.assertGreaterEqual(parts.time, 0.05)
        self.assertLess(parts.time, 0.06)
        parts.run(folder=self.folder / "parts")
        while not steps.finished:
            steps.step()
        for name in ("position", "velocity", "stress", "density"):
            self.assert_same(whole.field(name), parts.field(name), name)
            self.assert_same(whole.field(name), steps.field(name), name)
        self.assertTrue((self.folder / "parts" / "results.json").exists())

    def test_the_number_of_threads_changes_nothing(self):
        one, two = simulation(), scarp.Simulation(column(), threads=2, oversubscribe=True)
        one.run()
        two.run()
        self.assert_same(one.field("stress"), two.field("stress"))

    def test_a_callback_reads_and_ends(self):
        mine, times = simulation(), []

        def look(now):
            times.append(now.time)
            self.assertEqual(np.sum(now.view("id") >= 0), now.soil_count)
            return len(times) < 3

        mine.run(every="20 ms", callback=look)
        self.assertEqual([int(t / 0.02) for t in times], [1, 2, 3])
        self.assertFalse(mine.finished)
        with self.assertRaisesRegex(scarp.Error, "callback"):
            mine.run(callback=lambda now: now.step())
        with self.assertRaises(ZeroDivisionError):
            mine.run(callback=lambda now: 1 / 0)
        mine.run()
        self.assertTrue(mine.finished)

    def test_ctrl_c_ends_it_between_steps(self):
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        mine = simulation(column(stage=dict(name="spread", duration="1 h")))
        sent = []

        def send():
            sent.append(time.monotonic())
            os.kill(os.getpid(), signal.SIGINT)

        threading.Timer(0.3, send).start()
        with self.assertRaises(KeyboardInterrupt):
            mine.run()
        # A look takes place every 0.1 s, a step of 100 particles less than 1 ms; fifty times that for a busy machine.
        self.assertLess(time.monotonic() - sent[0], 5.0)
        steps = mine.last_step.step
        self.assertGreater(steps, 0)
        self.assertEqual(mine.step().step, steps + 1)

    def test_another_thread_sees_no_half_step(self):
        mine, answers = simulation(), []

        def read():
            try:
                mine.field("stress")
            except scarp.Error as error:
                answers.append(str(error))

        def ask(now):
            thread = threading.Thread(target=read)
            thread.start()
            thread.join()
            return False

        mine.run(callback=ask)
        self.assertEqual(len(answers), 1)
        self.assertIn("another thread", answers[0])
        read()
        self.assertEqual(len(answers), 1)

    def test_other_threads_go_on_while_it_steps(self):
        counted = []
        mine = simulation(column(stage=dict(name="spread", duration="1 h")))
        started = threading.Event()

        def count():
            started.wait()
            for number in range(20):
                counted.append(number)
                time.sleep(0.001)

        thread = threading.Thread(target=count)
        thread.start()
        mine.run(callback=lambda now: (started.set(), len(counted) < 20)[1], every="1 ms")
        thread.join()
        self.assertEqual(len(counted), 20)

    def test_the_energy_has_every_line(self):
        self.assertEqual(set(simulation().energies), {
            "kinetic", "kinetic_added", "potential", "elastic", "plastic", "viscous", "damping", "wall",
            "artificial_stress", "gradient_residue", "diffusion", "hooks", "sleep", "imbalance"})

    def test_an_instability_says_where(self):
        mine = simulation()
        mine.step_factor = 20.0
        with self.assertRaises(scarp.SimulationInstability) as caught:
            mine.run()
        error = caught.exception
        self.assertGreater(error.step, 0)
        self.assertEqual(error.stage, "spread")
        self.assertIn(error.field, str(error))
        self.assertTrue(error.advice)
        self.assertEqual(len(mine.field("position")), mine.soil_count)


class FieldTest(common.TestCase):
    def test_fields_come_by_id_and_can_be_set(self):
        mine = simulation()
        velocity = np.zeros((mine.soil_count, 3))
        velocity[:, 0] = mine.ids
        mine.set_field("velocity", velocity)
        self.assert_same(mine.field("velocity"), velocity)
        self.assertEqual(mine.field("id").dtype, np.int64)
        with self.assertRaisesRegex(scarp.Error, "finite"):
            mine.set_field("velocity", velocity * np.nan)
        with self.assertRaises(scarp.Error):
            mine.field("temperature")
        table = mine.table("velocity", "density")
        self.assertEqual(list(table), ["id", "velocity_x", "velocity_y", "velocity_z", "density"])
        self.assertEqual({column.shape for column in mine.table().values()}, {(mine.soil_count,)})

    def test_a_view_shows_the_particles_of_its_moment_only(self):
        mine = simulation(column(stage=dict(name="spread", duration="1 s")))
        mine.run(until=0.05)
        x, ids = mine.view("position", "x"), mine.view("id")
        held = ids[ids >= 0]
        by_id = np.zeros(mine.soil_count)
        by_id[held] = x[ids >= 0]
        self.assert_same(by_id, mine.field("position")[:, 0])
        mine.step()
        self.assertFalse(x.valid)
        for use in (lambda: x[0], lambda: x + 1.0, lambda: np.sum(x), lambda: np.asarray(x), lambda: len(x),
                    lambda: list(x), lambda: x == x, lambda: np.concatenate([x, x])):
            with self.assertRaisesRegex(scarp.Error, "is over"):
                use()
        self.assertIn("over", repr(x))

    def test_every_change_ends_a_view(self):
        mine = simulation()
        for change in (lambda: mine.set_field("density", mine.field("density")), lambda: mine.perturb(1e-3),
                       lambda: mine.run(until=0.001), lambda: mine.end_stage()):
            view = mine.view("density")
            self.assertTrue(view.valid)
            change()
            self.assertFalse(view.valid)

    def test_a_view_of_a_callback_ends_with_it(self):
        mine, kept = simulation(), []
        mine.run(until=0.01, callback=lambda now: kept.append(now.view("density")))
        self.assertGreater(len(kept), 1)
        self.assertFalse(any(view.valid for view in kept))

    def test_nothing_that_a_view_gives_lies_in_the_simulation(self):
        mine = simulation()
        mine.run(until=0.01)
        view = mine.view("stress", "yy")
        kept = []
        np.apply_along_axis(lambda values: kept.append(values) or 0.0, 0, view)
        with view._raw() as raw:
            self.assertFalse(any(np.shares_memory(values, raw) for values in kept))
            self.assertFalse(raw.flags.writeable)
            for given in (view[:], view[2:5], view.copy(), np.asarray(view), np.reshape(view, (-1, 1)), np.real(view),
                          np.split(view, 2)[0], np.atleast_1d(view), np.broadcast_to(view, (2, len(view))),
                          np.lib.stride_tricks.sliding_window_view(view, 3), np.ix_(view)[0], np.einsum("i->i", view),
                          +view, np.abs(view)):
                self.assertFalse(np.shares_memory(given, raw))
        before = mine.field("stress")
        view[:][:] = 0.0
        with self.assertRaises(TypeError):
            view[0] = 1.0
        with self.assertRaisesRegex(ValueError, "set_field"):
            view += 1.0
        with self.assertRaises(ValueError):
            np.copyto(view, 0.0)
        with self.assertRaises(ValueError):
            np.add.at(view, 0, 1.0)
        self.assert_same(mine.field("stress"), before)

    def test_views_of_what_is_not_there(self):
        mine = simulation()
        with self.assertRaisesRegex(scarp.Error, "2D"):
            mine.view("velocity", "z")
        with self.assertRaises(scarp.Error):
            mine.view("displacement", "x")
        with self.assertRaises(ValueError):
            mine.view("velocity", "w")

    def test_a_view_keeps_its_simulation(self):
        view = simulation().view("density")
        self.assertEqual(view.sum(), view.copy().sum())

    def test_measures(self):
        mine = simulation()
        mine.run(until=0.05)
        crest = mine.probe("crest")
        ids = np.flatnonzero((mine.field("position") == crest.position).all(axis=1))
        self.assertEqual(len(ids), 1)
        self.assert_same(crest.stress, mine.field("stress")[ids[0]])
        self.assertIn("accumulated_plastic_strain", crest.history)
        v = mine.field("velocity")
        kinetic = 0.5 * mine.soil_mass / mine.soil_count * np.sum(v**2)
        # Two sums of some 100 terms in another order.
        self.assertAlmostEqual(mine.energies["kinetic"] / kinetic, 1.0, delta=100 * 2.3e-16)
        self.assertEqual(set(mine.reactions), {"base", "side"})
        self.assertLess(mine.reactions["base"][1], 0.0)
        with self.assertRaises(scarp.Error):
            mine.probe("toe")


class StateTest(common.TestCase):
    def test_a_checkpoint_goes_on_bit_for_bit(self):
        whole = simulation()
        whole.run(until=0.1)
        whole.save(self.folder / "half.h5")
        copy = whole.clone()
        whole.run()
        again = scarp.Simulation.resume(column(), self.folder / "half.h5", threads=1)
        for other in (again, copy):
            other.run()
            self.assert_same(whole.field("stress"), other.field("stress"))
        with self.assertRaises(scarp.CheckpointError):
            scarp.Simulation.resume(column(spacing=0.2), self.folder / "half.h5")
        with self.assertRaises(scarp.CheckpointError):
            scarp.Simulation.resume(column(), self.folder / "none.h5")
        with self.assertRaises(scarp.FileError):
            whole.save(self.folder / "no" / "such" / "folder.h5")

    def test_particles_of_ones_own(self):
        place = np.array([[x, y] for x in (0.05, 0.15) for y in (0.05, 0.15)])
        mine = simulation(column(initial=None, probe=None),
                          particles=dict(position=place, id=[7, 5, 3, 1], velocity=0.0 * place))
        self.assert_same(mine.ids, [1, 3, 5, 7])
        self.assert_same(mine.field("position")[:, :2], place[::-1])
        with self.assertRaises(scarp.SceneError):
            simulation(column(initial=None, probe=None), particles=dict(position=place, id=[1, 1, 2, 3]))


def frictionless(step):
    """Drucker-Prager's cone for phi = 0 in plane strain: sqrt(J2) <= c, the deviator shrinks onto it."""
    weights = np.array([1.0, 1.0, 1.0, 2.0, 2.0, 2.0])
    mean = step.trial[:, :3].mean(axis=1)
    deviator = step.trial - mean[:, None] * np.array([1.0, 1.0, 1.0, 0.0, 0.0, 0.0])
    root_j2 = np.sqrt(0.5 * (deviator**2 @ weights))
    factor = np.minimum(1.0, 2e3 / np.maximum(root_j2, 1e-30))
    step.history["shrunk"] += root_j2 * (1.0 - factor)
    return step.trial + (factor - 1.0)[:, None] * deviator


class ModelTest(common.TestCase):
    numerics = dict(stress_diffusion=0)  # elastic materials have none

    def elastic(self, integrator="kick_drift_kick", force_correction=True, **changes):
        soil = {name: CLAY[name] for name in ("name", "density", "youngs_modulus", "poisson_ratio")}
        return column(material={**soil, "model": "linear_elastic"}, numerics={**self.numerics, "integrator": integrator,
                                                                            "force_correction": force_correction,
                                                                            "cfl": 0.3}, **changes)

    def test_a_model_of_numpy_is_the_compiled_one(self):
        compiled = simulation(column(material={**CLAY, "friction_angle": 0}, numerics={**self.numerics, "cfl": 0.3}))
        tried = simulation(self.elastic())
        tried.set_model(frictionless, history=dict(shrunk=0.0))
        for _ in range(100):
            compiled.step()
            tried.step()
        shrunk = tried.model_history()["shrunk"]
        self.assertGreater(np.count_nonzero(shrunk), tried.soil_count // 4)  # most of it has yielded
        scale = np.abs(compiled.field("stress")).max()
        # Each step rounds the return some ten times; 100 steps of a motion that does not amplify.
        self.assertLess(np.abs(compiled.field("stress") - tried.field("stress")).max(), 100 * 10 * 2.3e-16 * scale * 100)
        self.assert_same(shrunk > 0.0, compiled.field("accumulated_plastic_strain") > 0.0)

    def test_the_strain_is_that_of_the_step(self):
        cube = dict(dimension=3, body=dict(material="clay", box=dict(min=[0, 0, 0], max=[0.4, 0.4, 0.4])), probe=None,
                    wall=dict(name="base", kind="no_slip", plane=dict(point=[0, 0, 0], normal=[0, 0, 1], size=3)))
        for changes in (dict(), dict(force_correction=False), cube):
            with self.subTest(changes):
                self.compare_strain(simulation(self.elastic(initial=None, **changes)))  # without stress, which would turn

    def compare_strain(self, mine):
        seen = []

        def look(step):
            seen.append(step)
            return step.trial

        mine.set_model(look)
        mine.set_field("velocity", np.cos(mine.field("position") @ [[3, 1, 2], [2, 5, 1], [1, 2, 7]]))
        mine.step()
        step = seen[0]
        self.assertEqual(np.count_nonzero(np.abs(step.strain).max(axis=0) > 1e-6), 3 if mine.scene.dimension == 2 else 6)
        shear, bulk = 10e6 / 2.6, 10e6 / 1.2  # E/(2(1+nu)), E/(3(1-2 nu))
        volume = step.strain[:, :3].sum(axis=1, keepdims=True)
        unit = np.array([1.0, 1.0, 1.0, 0.0, 0.0, 0.0])
        elastic = step.stress + 2 * shear * (step.strain - volume / 3 * unit) + bulk * volume * unit
        self.assertGreater(np.abs(step.trial).max(), 1.0)
        np.testing.assert_allclose(step.trial, elastic, rtol=0, atol=1e-12 * np.abs(step.trial).max())

    def test_what_a_model_does_wrong_is_said(self):
        for update, words in ((lambda step: step.trial[:-1], "shape"), (lambda step: step.trial * np.nan, "finite")):
            mine = simulation(self.elastic())
            mine.set_model(update)
            with self.assertRaisesRegex(scarp.Error, words):
                mine.run()
        mine = simulation(self.elastic())
        mine.set_model(lambda step: 1 / 0)
        with self.assertRaises(ZeroDivisionError):
            mine.step()
        with self.assertRaisesRegex(scarp.Error, "linear_elastic"):
            simulation().set_model(frictionless)
        with self.assertRaisesRegex(scarp.Error, "kick_drift_kick"):
            simulation(self.elastic(integrator="verlet")).set_model(frictionless)
        with self.assertRaisesRegex(scarp.Error, "copied"):
            mine.clone()


if __name__ == "__main__":
    unittest.main()
