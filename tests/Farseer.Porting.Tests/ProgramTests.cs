using System;
using Farseer.Porting.Tests.Programs;
using Xunit;

namespace Farseer.Porting.Tests
{
    /// <summary>The programs do what their games call for. Steps are 1/60 s.</summary>
    public sealed class ProgramTests
    {
        private const float Dt = 1f / 60;

        [Fact]
        public void PlatformerHero_RunsAndJumps_CollectsCoinsAndLandsOnTheStep()
        {
            var game = new PlatformerHero();
            for (int i = 0; i < 60; i++)
            {
                game.Update(Dt, false, false);
            }

            Assert.True(game.IsOnGround);

            // The floor's top is at 190 and the hero is 32 high: it stands at 174, and two rest depths lower at most.
            Assert.InRange(game.Position.Y, 174, 174.1f);

            for (int i = 0; i < 400; i++)
            {
                game.Update(Dt, game.Position.X < 290, game.Position.X > 150 && game.Position.X < 200);
            }

            Assert.Equal(3, game.Coins);
            Assert.InRange(game.Jumps, 1, 3);
            Assert.True(game.IsOnGround);
            Assert.InRange(game.Position.Y, 134, 134.1f);
            // The largest float as inertia: only rounding-sized turns.
            Assert.InRange(game.Rotation, -1e-30f, 1e-30f);
        }

        [Fact]
        public void PooledBullets_FiredForTenSeconds_AreUsedAgain()
        {
            var game = new PooledBullets();
            for (int i = 0; i < 600; i++)
            {
                if (i % 6 == 0)
                {
                    game.Fire(i % 12 == 0 ? 0 : 3);
                }

                game.Update(Dt);
            }

            Assert.Equal(100, game.Fired);
            Assert.InRange(game.Hits, 40, 50);
            Assert.InRange(game.Made, 10, 30);
            Assert.True(game.TargetSpeed > 5, $"The target moves at {game.TargetSpeed}.");
        }

        [Theory]
        [InlineData(400f, true)]
        [InlineData(60f, false)]
        public void BreakableWall_HitByBall_BreaksOnlyWhenHitHard(float speed, bool breaks)
        {
            var game = new BreakableWall(speed);
            for (int i = 0; i < 300; i++)
            {
                game.Update(Dt);
            }

            Assert.Equal(10, game.Bricks + game.Debris.Count);
            Assert.Equal(breaks, game.Debris.Count > 0);

            // What broke off lies on the floor (top at 100), not in it.
            Assert.All(game.Debris, piece => Assert.True(piece.Position.Y < 95));
        }

        [Fact]
        public void PhysicsThread_RunsFrames_GivesTheSameAsInOneThread()
        {
            using var threaded = new PhysicsThread();
            for (int i = 0; i < 120; i++)
            {
                threaded.Frame(Dt);
            }

            Assert.Equal(120, threaded.Frames);

            // The box rests on the floor (top at 50) by half its height.
            Assert.InRange(threaded.Box.Position.Y, 45, 45.06f);
        }

        [Fact]
        public void Billiards_Broken_AllBallsStayOnTheTableAndSlowDown()
        {
            var game = new Billiards();
            game.Shoot(500);
            float first = 0;
            int moved = 0;
            for (int i = 0; i < 600; i++)
            {
                game.Update(Dt);
                first = i == 0 ? game.Energy() : first;
                moved = Math.Max(moved, game.Moved);
                Assert.True(game.AllOnTable());
            }

            Assert.Equal(16, moved);
            Assert.True(game.Energy() < 0.2f * first, $"{game.Energy()} of {first}");
        }

        [Fact]
        public void Asteroids_TurnAndThrust_MovesWhereTheNosePoints()
        {
            var game = new Asteroids();
            for (int i = 0; i < 20; i++)
            {
                game.Update(Dt, 1, false);
            }

            for (int i = 0; i < 20; i++)
            {
                game.Update(Dt, -1, false);
            }

            Vector2 nose = game.Nose() - game.Ship.Position;
            // The default drag leaves a little spin: it turns the nose by less than a degree in a second.
            for (int i = 0; i < 60; i++)
            {
                game.Update(Dt, 0, true);
            }

            Vector2 velocity = game.Ship.LinearVelocity;
            velocity.Normalize();
            nose.Normalize();
            float cosine;
            Vector2.Dot(ref velocity, ref nose, out cosine);
            Assert.True(game.Ship.Rotation != 0);
            Assert.True(cosine > 0.99f, $"cosine {cosine}");
        }
    }
}
