"""The environments of labmouse.learn have the same contests as races, and pass Gymnasium's own checks."""

import json
import os
import signal
import subprocess
import sys
import warnings

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import labmouse

gymnasium = pytest.importorskip("gymnasium")
from gymnasium.utils.env_checker import check_env  # noqa: E402
from gymnasium.wrappers.vector import RecordEpisodeStatistics  # noqa: E402

from labmouse import learn  # noqa: E402
from labmouse.learn.playing import play  # noqa: E402
from labmouse.learn.policy import WEIGHTS  # noqa: E402
from labmouse.learn.train import train  # noqa: E402

SMALL = learn.MazeSet("train", kind="depth-first", size=5, loops=0.2)
OBSERVATIONS = ("sighting", "belief", "bits")


class Replayed:
    """Plays the actions of a list, to repeat a contest of an environment in a race."""

    def __init__(self, numbers):
        self.actions = iter(numbers)

    def decide(self, seen):
        return learn.action_of(next(self.actions)) or "reset"


def test_a_set_of_mazes_takes_a_size_of_numpy():
    same = learn.MazeSet("train", kind="depth-first", size=np.int64(5), loops=0.2)
    assert same.size == (5, 5) and same[3] == SMALL[3]


@pytest.mark.parametrize("observation", OBSERVATIONS)
def test_gymnasium_finds_no_fault(observation):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(learn.ContestEnv(SMALL, observation), skip_render_check=True)


def test_both_environments_are_registered():
    assert gymnasium.make("labmouse/Contest-v0", mazes=SMALL).unwrapped.__class__ is learn.ContestEnv
    made = gymnasium.make_vec("labmouse/Contest-v0", num_envs=3, mazes=SMALL)
    assert made.unwrapped.__class__ is learn.ContestVectorEnv
    assert made.observation_space.shape == (3, 16)


@settings(deadline=None, max_examples=25)
@given(st.integers(0, 2**62), st.data())
def test_the_return_is_minus_the_score_of_the_race(seed, data):
    """Exactly, for any actions; it is -100 for a failed contest."""
    env = learn.ContestEnv(SMALL, budget=60)
    _, info = env.reset(seed=seed)
    maze = SMALL[info["maze"]]
    dice = np.random.default_rng(data.draw(st.integers(0, 2**32)))
    actions, total, ended = [], 0.0, False
    while not ended:
        valid = np.flatnonzero(info["action_mask"])
        actions.append(learn.RESET if learn.RESET in valid else int(dice.choice(valid)))
        _, reward, ended, truncated, info = env.step(actions[-1])
        total += reward
        assert not truncated
    raced = labmouse.race({"replayed": lambda: Replayed(actions)}, maze, budget=60, jobs=1, progress=False).table.iloc[0]
    assert (raced["outcome"] == "finished") == (info["state"] == 1)
    assert total == info["return"] == -(raced["score"] if info["state"] == 1 else 100.0)


def test_an_environment_of_the_vector_plays_what_a_single_one_does():
    envs = learn.ContestVectorEnv(6, SMALL, "belief", budget=40, copy=True)
    env = learn.ContestEnv(SMALL, "belief", budget=40)
    seen, _ = envs.reset(seed=70)
    own, _ = env.reset(seed=73)
    ended = False
    for _ in range(200):
        assert (seen[3] == own).all()
        actions = envs.draw_valid_actions()
        seen, rewards, ends, _, _ = envs.step(actions)
        if ended:  # this step has begun the next contest
            own, _ = env.reset()
            reward, ended = 0.0, False
        else:
            own, reward, ended, _, _ = env.step(actions[3])
        assert (rewards[3], ends[3]) == (reward, ended)


@pytest.mark.parametrize("observation", OBSERVATIONS)
def test_equal_seeds_give_equal_contests(observation):
    walks = []
    for _ in range(2):
        envs = learn.ContestVectorEnv(5, "train", observation)
        first, _ = envs.reset(seed=11)
        walk = [first.copy()]
        for _ in range(30):
            walk.append(envs.step(envs.draw_valid_actions())[0].copy())
        walks.append(np.stack(walk))
    assert (walks[0] == walks[1]).all()


def test_bits_and_belief_say_the_same():
    bits, belief = (learn.ContestVectorEnv(8, "train", observation) for observation in ("bits", "belief"))
    words, planes = bits.reset(seed=3)[0], belief.reset(seed=3)[0]
    for _ in range(50):
        assert (learn.planes_of(words) == planes).all()
        actions = bits.draw_valid_actions()
        bits.step(actions)
        belief.step(actions)
    assert (bits.sightings == belief.sightings).all()


def test_observations_lie_in_their_space():
    for observation in OBSERVATIONS:
        envs = learn.ContestVectorEnv(4, SMALL, observation, budget=50)
        seen, _ = envs.reset(seed=1)
        for _ in range(120):
            assert envs.observation_space.contains(seen)
            seen = envs.step(envs.draw_valid_actions())[0]


def test_arrays_are_the_same_memory_and_not_to_be_written_to():
    envs = learn.ContestVectorEnv(4, SMALL)
    first, info = envs.reset(seed=1)
    second, rewards, *_ = envs.step(envs.draw_valid_actions())
    assert np.shares_memory(first, second)
    for array in (first, rewards, info["action_mask"]):
        with pytest.raises(ValueError):
            array[0] = 0


def test_copies_do_not_change():
    envs = learn.ContestVectorEnv(4, SMALL, copy=True)
    first, info = envs.reset(seed=1)
    arrays = first, info["action_mask"], info["return"]
    before = [array.copy() for array in arrays]
    for _ in range(5):
        envs.step(envs.draw_valid_actions())
    assert all((now == then).all() for now, then in zip(arrays, before))
    first[0] = 0  # copies are writable


def test_memory_outlives_its_environment():
    seen, _ = learn.ContestVectorEnv(100, "train", "bits").reset(seed=1)
    kept = seen.copy()
    learn.ContestVectorEnv(100, "train", "bits").reset(seed=2)
    assert (seen == kept).all()


def test_statistics_of_gymnasium_see_the_returns():
    envs = RecordEpisodeStatistics(learn.ContestVectorEnv(3, SMALL, budget=20))
    envs.reset(seed=1)
    for _ in range(20):
        *_, ends, _, info = envs.step(envs.unwrapped.draw_valid_actions())
    assert (info["episode"]["r"][ends] == info["return"][ends].astype(np.float32)).all()
    assert ends.any()


def test_part_of_a_batch_begins_anew():
    envs = learn.ContestVectorEnv(3, SMALL)
    envs.reset(seed=1)
    envs.step(envs.draw_valid_actions())
    envs.reset(options={"reset_mask": np.array([True, False, True])})
    assert envs.sightings[:, learn.COLUMNS.index("steps_left")].tolist() == [1000, 999, 1000]


#: A shell starts background processes with SIGINT ignored.
HEARS = "import os, signal, sys; signal.signal(signal.SIGINT, signal.default_int_handler)\n"
MADE = HEARS + """
import threading, time
from labmouse import learn
envs = learn.ContestVectorEnv(100_000, "train")  # whose mazes take minutes
threading.Timer(0.5, lambda: (sent.append(time.monotonic()), os.kill(os.getpid(), signal.SIGINT))).start()
sent = []
try:
    envs.reset(seed=1)
except KeyboardInterrupt:
    print(time.monotonic() - sent[0])
"""


def test_ctrl_c_is_heard_between_mazes_that_are_made():
    ran = subprocess.run([sys.executable, "-c", MADE], capture_output=True, text=True, timeout=60, check=True)
    assert float(ran.stdout) < 5


def test_training_that_is_stopped_gives_its_best(tmp_path):
    code = HEARS + "from labmouse.learn.train import main; main()"
    words = {"--out": tmp_path / "mouse.json", "--generations": 10**6, "--size": 6, "--budget": 60, "--kind": "depth-first"}
    with subprocess.Popen([sys.executable, "-c", code, *(str(word) for pair in words.items() for word in pair)],
                          stdout=subprocess.PIPE, text=True) as training:
        first = training.stdout.readline()
        os.kill(training.pid, signal.SIGINT)
        rest = training.stdout.read()
    assert training.returncode == 0 and "generation" in first and "interrupted" in rest
    written = json.loads((tmp_path / "mouse.json").read_text())
    assert len(written["weights"]) == WEIGHTS and written["curve"]


def test_a_wrong_action_is_refused():
    env, envs = learn.ContestEnv(SMALL), learn.ContestVectorEnv(2, SMALL)
    env.reset(seed=1)
    envs.reset(seed=1)
    for wrong in (-1, learn.ACTIONS):
        with pytest.raises(labmouse.Error):
            env.step(wrong)
        with pytest.raises(labmouse.Error):
            envs.step(np.array([0, wrong]))
    with pytest.raises(labmouse.Error):
        envs.step(np.zeros(3, np.int64))


@pytest.mark.parametrize(
    "arguments", [{"mazes": "no-such-maze"}, {"observation": "pixels"}, {"order": "sorted"}, {"budget": 0}, {"num_envs": 0}]
)
def test_what_cannot_be_is_refused(arguments):
    with pytest.raises(ValueError):
        learn.ContestVectorEnv(**arguments)


def test_a_contest_that_has_ended_takes_no_step():
    env = learn.ContestEnv(SMALL, budget=1)
    env.reset(seed=1)
    assert env.step(learn.number_of(90))[2]
    with pytest.raises(gymnasium.error.ResetNeeded):
        env.step(learn.number_of(90))
    env.reset()
    assert env.step(learn.number_of(90))[2]


def test_a_set_is_a_sequence():
    mazes = learn.MazeSet("test", kind="wilson", size=5, count=4)
    assert list(mazes) == [mazes[0], mazes[1], mazes[2], mazes[-1]] == mazes[:]
    assert mazes[-4] == mazes[0] != mazes[-1]
    for outside in (4, -5):
        with pytest.raises(IndexError):
            mazes[outside]
    assert learn.MazeSet("test", kind="wilson", size=5, loops=0.5)[0] != mazes[0]
    with pytest.raises(TypeError):
        len(learn.MazeSet("test"))


def test_the_learned_mouse_does_not_drive():
    record = labmouse.run({"learned": learn.Learned.load()}, "contest-01", world="seconds")
    assert record.outcome == "forfeit: not started" and "steps" in record.last_words


def test_every_action_has_its_number():
    assert [learn.number_of(*(learn.action_of(number) or (None,))) for number in range(learn.ACTIONS)] == list(range(learn.ACTIONS))


def test_sets_share_no_maze():
    """In a size with so few mazes that each set makes the same one many times."""
    sets = {split: {learn.MazeSet(split, kind="wilson", size=3)[n] for n in range(400)} for split in ("train", "validation", "test")}
    assert not sets["train"] & sets["test"] and not sets["train"] & sets["validation"] and not sets["validation"] & sets["test"]
    assert all(learn.split_of(maze) == split for split, mazes in sets.items() for maze in mazes)


def test_mazes_come_from_files_and_lists(tmp_path):
    for number, maze in enumerate(learn.MazeSet("test", size=12)[:3]):
        maze.save(tmp_path / f"{number}.txt")
    from_folder, from_list = learn.ContestVectorEnv(3, tmp_path, order="in turn"), learn.ContestVectorEnv(3, labmouse.mazes(tmp_path), order="in turn")
    assert (from_folder.reset(seed=1)[0] == from_list.reset(seed=1)[0]).all()
    assert from_folder.reset(seed=1)[1]["maze"].tolist() == [0, 1, 2]


def test_the_learned_mouse_scores_in_races_what_it_returned_in_the_environment():
    mazes, mouse = learn.MazeSet("test")[:4], learn.Learned.load()
    raced = labmouse.race({"learned": mouse}, mazes, jobs=1, progress=False).table
    assert (raced["outcome"] == "finished").all()
    assert sorted(raced["score"]) == sorted(-play(mouse.weights[None], mazes)[0])


def test_the_learned_mouse_beats_cautious_and_itself_shuffled():
    mazes, mouse = learn.MazeSet("test")[1000:1060], learn.Learned.load()
    cautious = labmouse.race("cautious", mazes, runs=5, progress=False).table.fillna({"score": 100.0}).groupby("maze")["score"].mean()
    learned, shuffled = -play(np.stack([mouse.weights, mouse.shuffled().weights]), mazes)
    own = np.array([cautious[maze.name] for maze in mazes])
    for other in (own, shuffled):
        better = other - learned
        assert better.mean() - 2 * better.std() / np.sqrt(len(better)) > 0


def test_training_gets_better_and_is_repeatable():
    first, second = (train(seconds=600, generations=3, jobs=1, seed=2, size=6, budget=60, kind="depth-first") for _ in range(2))
    assert first["weights"] == second["weights"] and len(first["weights"]) == WEIGHTS
    assert first["curve"][-1]["validation"] < first["curve"][0]["validation"]
    json.dumps(first)
