PRAGMA application_id = 1280144244; PRAGMA user_version = 1;
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE worlds (
  id INTEGER PRIMARY KEY,
  text TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  conditions TEXT NOT NULL,
  unit TEXT NOT NULL);
INSERT INTO worlds VALUES(1,replace('world strides\nedition 1\nformula speed-run steps + exploration steps / 30\nfailure 100\nconditions {"budget":1000}\nfields maze seed outcome score exploration_steps speed_steps discovered_share visited_share microseconds_per_decision blocked_steps void_rotations cut_movements idle_resets last_words counts\n','\n',char(10)),'strides','{"budget":1000}','steps');
INSERT INTO worlds VALUES(2,replace('world seconds\nedition 1\nformula the best of at most 5 runs in 300 s, gate to gate\nfailure none\nconditions {"rules":{"name":"all-japan","source":"All-Japan Micromouse, classic class, 2020s; five minutes are an assumption","time_limit":300000000,"most_runs":5,"maze_time_divisor":0,"gate_to_gate":true,"touch_penalty":0,"untouched_bonus":0},"robot":{"name":"classic","parameters":{"cell":180.0,"sight":1,"straight.speed":3000.0,"straight.acceleration":10000.0,"straight.braking":10000.0,"diagonal.speed":2500.0,"diagonal.acceleration":8000.0,"diagonal.braking":8000.0,"clearance":45.0,"run_up":40.0,"curve.lateral_acceleration":10000.0,"curve.yaw_acceleration":300.0,"curve.speeds":6,"stop":"goal","search.speed":500.0,"search.pivot_speed":10.0,"search.pivot_acceleration":100.0}},"tables":"237e7549c1a1d571"}\nfields maze seed outcome score search_us best_us excess proven starts decisions replanned discovered_share visited_share\n','\n',char(10)),'seconds','{"rules":{"name":"all-japan","source":"All-Japan Micromouse, classic class, 2020s; five minutes are an assumption","time_limit":300000000,"most_runs":5,"maze_time_divisor":0,"gate_to_gate":true,"touch_penalty":0,"untouched_bonus":0},"robot":{"name":"classic","parameters":{"cell":180.0,"sight":1,"straight.speed":3000.0,"straight.acceleration":10000.0,"straight.braking":10000.0,"diagonal.speed":2500.0,"diagonal.acceleration":8000.0,"diagonal.braking":8000.0,"clearance":45.0,"run_up":40.0,"curve.lateral_acceleration":10000.0,"curve.yaw_acceleration":300.0,"curve.speeds":6,"stop":"goal","search.speed":500.0,"search.pivot_speed":10.0,"search.pivot_acceleration":100.0}},"tables":"237e7549c1a1d571"}','s');
CREATE TABLE mice (
  id INTEGER PRIMARY KEY,
  text TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  spec TEXT NOT NULL,
  parameters TEXT NOT NULL,
  about TEXT NOT NULL);
INSERT INTO mice VALUES(1,replace('mouse random\nstride 3\norder python-3.4\nsignature 72f14def26894c21-c2765e5553db943f\n','\n',char(10)),'random','random','{"stride":"3","order":"python-3.4"}','{"uses_chance":true}');
INSERT INTO mice VALUES(2,replace('mouse flood\nstride 3\nsignature 72f14def26894c21-c2765e5553db943f\n','\n',char(10)),'flood','flood','{"stride":"3"}','{}');
INSERT INTO mice VALUES(3,replace('mouse flood\nsignature 72f14def26894c21-c2765e5553db943f\n','\n',char(10)),'flood','flood','{}','{}');
CREATE TABLE mazes (
  id INTEGER PRIMARY KEY,
  text TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  width INTEGER NOT NULL,
  height INTEGER NOT NULL);
INSERT INTO mazes VALUES(1,'1.3x1.AAn.CA.A..JSJl1B','corridor.txt',3,1);
CREATE TABLE bounds (
  world INTEGER NOT NULL REFERENCES worlds,
  maze INTEGER NOT NULL REFERENCES mazes,
  bound REAL,
  PRIMARY KEY (world, maze)) WITHOUT ROWID;
INSERT INTO bounds VALUES(1,1,1.0666666666666666518);
INSERT INTO bounds VALUES(2,1,0.35999999999999998667);
CREATE TABLE builds (
  id INTEGER PRIMARY KEY,
  version TEXT NOT NULL,
  compiler TEXT NOT NULL,
  processor TEXT NOT NULL,
  UNIQUE (version, compiler, processor));
INSERT INTO builds VALUES(1,'0.1.0+c64d12d-dirty','g++ 12.2.0','Intel(R) Xeon(R) Processor');
CREATE TABLE contests (
  id INTEGER PRIMARY KEY,
  world INTEGER NOT NULL REFERENCES worlds,
  mouse INTEGER NOT NULL REFERENCES mice,
  maze INTEGER NOT NULL REFERENCES mazes,
  seed INTEGER NOT NULL,
  run INTEGER NOT NULL,
  race_seed TEXT NOT NULL,
  outcome TEXT NOT NULL,
  outcome_order INTEGER NOT NULL,
  never_started TEXT NOT NULL,
  score REAL,
  counted REAL,
  ratio REAL,
  fields TEXT NOT NULL,
  figures TEXT NOT NULL,
  build INTEGER NOT NULL REFERENCES builds,
  time INTEGER NOT NULL,
  UNIQUE (world, mouse, maze, seed));
INSERT INTO contests VALUES(1,1,1,1,4828205498696741,0,'1','solved',0,'',1.1333333333333333037,1.1333333333333333037,1.0625,'{"score":1.1333333333333333,"exploration_steps":4,"speed_steps":1,"discovered_share":1.0,"visited_share":1.0}','[4,1,1.0,1.0,[],[],[],[],0,[],[],5,0.0]',1,1795464851);
INSERT INTO contests VALUES(2,1,1,1,5947181353371311,1,'1','solved',0,'',1.1333333333333333037,1.1333333333333333037,1.0625,'{"score":1.1333333333333333,"exploration_steps":4,"speed_steps":1,"discovered_share":1.0,"visited_share":1.0}','[4,1,1.0,1.0,[],[],[],[],0,[],[],5,0.0]',1,1795464851);
INSERT INTO contests VALUES(3,1,2,1,4828205498696741,0,'1','solved',0,'',1.0666666666666666518,1.0666666666666666518,1.0,'{"score":1.0666666666666667,"exploration_steps":2,"speed_steps":1,"discovered_share":1.0,"visited_share":1.0}','[2,1,1.0,1.0,[],[],[],[],0,[],[],3,0.0]',1,1795464851);
INSERT INTO contests VALUES(4,2,3,1,4828205498696741,0,'1','finished',0,'',0.35999999999999998667,0.35999999999999998667,1.0,'{"score":{"value":360000,"run":1,"gate_to_gate":360000,"rest_to_centre":1027080,"maze_time":0,"bonus":0},"search_us":2468319,"best_us":1027080,"excess":null,"proven":false,"starts":1,"decisions":3,"replanned":2,"discovered_share":1.0,"visited_share":1.0}','[{"json":"{\"value\":360000,\"run\":1,\"gate_to_gate\":360000,\"rest_to_centre\":1027080,\"maze_time\":0,\"bonus\":0}"},2468319,1027080,null,false,1,3,2,1.0,1.0,360000,360000,1027080]',1,1795464851);
CREATE TABLE timings (
  contest INTEGER PRIMARY KEY REFERENCES contests ON DELETE CASCADE,
  figures TEXT NOT NULL);
INSERT INTO timings VALUES(1,'[5.961]');
INSERT INTO timings VALUES(2,'[1.547]');
INSERT INTO timings VALUES(3,'[2.499]');
CREATE VIEW results AS
SELECT contests.id, worlds.name AS world, worlds.conditions, mice.name AS mouse, mazes.name AS maze, seed, run, race_seed,
       outcome, score, counted, ratio, fields, version, compiler, processor, time
  FROM contests
  JOIN worlds ON worlds.id = contests.world
  JOIN mice ON mice.id = contests.mouse
  JOIN mazes ON mazes.id = contests.maze
  JOIN builds ON builds.id = contests.build;
CREATE VIEW standings AS
SELECT worlds.name AS world, worlds.conditions, contests.world AS world_id, mice.name AS mouse, contests.mouse AS mouse_id,
       count(DISTINCT contests.maze) AS mazes, count(*) AS contests, count(score) AS solved, avg(counted) AS mean,
       avg(score) AS mean_solved, avg(ratio) AS mean_ratio
  FROM contests
  JOIN bounds ON bounds.world = contests.world AND bounds.maze = contests.maze AND bound IS NOT NULL
  JOIN worlds ON worlds.id = contests.world
  JOIN mice ON mice.id = contests.mouse
 GROUP BY contests.world, contests.mouse
 ORDER BY contests.world, mean;
CREATE VIEW pairs AS
WITH means AS (
  SELECT contests.world, contests.mouse, contests.maze, avg(counted) AS mean
    FROM contests
    JOIN bounds ON bounds.world = contests.world AND bounds.maze = contests.maze AND bound IS NOT NULL
   WHERE counted IS NOT NULL
   GROUP BY contests.world, contests.mouse, contests.maze)
SELECT worlds.name AS world, worlds.conditions, one.world AS world_id, mice.name AS mouse, one.mouse AS mouse_id,
       others.name AS against, other.mouse AS against_id, count(*) AS mazes, avg(one.mean - other.mean) AS difference,
       sum(one.mean < other.mean) AS better, sum(one.mean = other.mean) AS equal, sum(one.mean > other.mean) AS worse
  FROM means AS one
  JOIN means AS other ON other.world = one.world AND other.maze = one.maze AND other.mouse <> one.mouse
  JOIN worlds ON worlds.id = one.world
  JOIN mice ON mice.id = one.mouse
  JOIN mice AS others ON others.id = other.mouse
 GROUP BY one.world, one.mouse, other.mouse;
COMMIT;
