using System.Collections.Generic;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Controllers;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Mathematics;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>A pool of water with waves in which a light box floats and a heavy one sinks.</summary>
    public class Water
    {
        private readonly PhysicsSimulator _physicsSimulator = new PhysicsSimulator(new Vector2(0, 150));
        private readonly WaveController _waveController;
        private readonly FluidDragController _fluidDragController;

        public Water()
        {
            _waveController = new WaveController();
            _waveController.Position = ConvertUnits.ToSimUnits(new Vector2(-25, 100));
            _waveController.Width = 500;
            _waveController.Height = 300;
            _waveController.NodeCount = 40;
            _waveController.DampingCoefficient = .95f;
            _waveController.Frequency = .16f;
            _waveController.WaveGeneratorMax = 1f;
            _waveController.WaveGeneratorMin = -1f;
            _waveController.WaveGeneratorStep = 0;
            _waveController.Initialize();

            _fluidDragController = new FluidDragController();
            _fluidDragController.Initialize(_waveController, .004f, .98f, .2f, _physicsSimulator.Gravity);
            Entered = new List<Geom>();
            _fluidDragController.Entry += delegate(Geom geom) { Entered.Add(geom); };

            Float = Box(150, .5f);
            Stone = Box(300, 8);
            _physicsSimulator.Add(_waveController);
            _physicsSimulator.Add(_fluidDragController);
        }

        public Body Float { get; private set; }

        public Body Stone { get; private set; }

        public List<Geom> Entered { get; private set; }

        public float Surface
        {
            get { return _waveController.Position.Y; }
        }

        public void Update(float dt)
        {
            _physicsSimulator.Update(dt);
        }

        private Body Box(float x, float mass)
        {
            Body body = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 20, 20, mass);
            body.Position = new Vector2(x, _waveController.Position.Y - 40);
            Geom geom = GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, body, 20, 20);
            _fluidDragController.AddGeom(geom);
            return body;
        }
    }
}
