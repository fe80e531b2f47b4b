using System;
using System.Threading;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;

namespace Farseer.Porting.Tests.Programs
{
    /// <summary>The simulator on a thread of its own; the game waits for it at the end of each frame.</summary>
    public class PhysicsThread : IDisposable
    {
        private readonly AutoResetEvent _idle = new AutoResetEvent(false);
        private readonly AutoResetEvent _wake = new AutoResetEvent(false);
        private readonly PhysicsSimulator _physicsSimulator;
        private readonly Thread _thread;
        private volatile bool _exit;
        private float _elapsed;

        public PhysicsThread()
        {
            _physicsSimulator = new PhysicsSimulator(new Vector2(0, 100));
            Body floor = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 200, 20, 1);
            floor.IsStatic = true;
            floor.Position = new Vector2(0, 60);
            GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, floor, 200, 20);
            Box = BodyFactory.Instance.CreateRectangleBody(_physicsSimulator, 10, 10, 1);
            GeomFactory.Instance.CreateRectangleGeom(_physicsSimulator, Box, 10, 10);
            _thread = new Thread(Loop);
            _thread.IsBackground = true;
            _thread.Start();
        }

        public Body Box { get; private set; }

        public int Frames { get; private set; }

        public void Frame(float elapsed)
        {
            _elapsed = elapsed;
            _wake.Set();
            _idle.WaitOne();
            Frames++;
        }

        public void Dispose()
        {
            _exit = true;
            _wake.Set();
            _thread.Join();
            _wake.Close();
            _idle.Close();
        }

        private void Loop()
        {
            while (true)
            {
                _wake.WaitOne();
                if (_exit)
                {
                    return;
                }

                _physicsSimulator.Update(_elapsed);
                _idle.Set();
            }
        }
    }
}
