using System;
using System.Numerics;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Serialization;

var simulator = new PhysicsSimulator(new Vector2(0, -10));
Body ball = BodyFactory.Instance.CreateCircleBody(simulator, 0.5f, 1);
GeomFactory.Instance.CreateCircleGeom(simulator, ball, 0.5f, 16);
simulator.Update(0.5f);
PhysicsSimulator loaded = SceneFile.LoadSimulator(SceneFile.Save(simulator, new SceneFileOptions { ExactState = true }));
simulator.Update(0.5f);
loaded.Update(0.5f);
Console.WriteLine(simulator.MotionHash() == loaded.MotionHash());
