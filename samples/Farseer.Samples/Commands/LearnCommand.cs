using System;
using System.CommandLine;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Numerics;
using Farseer.CommandLines;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Dynamics.Joints;
using FarseerGames.FarseerPhysics.Factories;
using FarseerGames.FarseerPhysics.Views;

namespace Farseer.Samples.Commands;

/// <summary>
/// Learns to balance a pole on a cart, by random search in a <see cref="WorldBatch"/>: each turn changes the best weights of a linear law
/// at random in sixteen ways, tries each from four tilts side by side, and keeps what balances longest. Draws the best run.
/// </summary>
internal static class LearnCommand
{
    private const int Tries = 16;
    private const int Tilts = 4;
    private const int Worlds = Tries * Tilts;
    private const int Weights = 4;
    private const int EpisodeSteps = 500;
    private const int DefaultTurns = 60;
    private const int BarWidth = 30;
    private const float Dt = 1f / 50;
    private const float FirstSpread = 0.5f;

    /// <summary>What a weight is worth: a tilt is a tenth of a unit where a place is one.</summary>
    private static readonly float[] _scales = [1, 1, 12, 4];

    private static readonly ValueOption<int> _turns = Values.Whole("--turns", "turns of the search at most", 1, int.MaxValue, DefaultTurns);
    private static readonly ValueOption<int> _seed = Values.Whole("--seed", "of the search", 0, int.MaxValue, 1);
    private static readonly ValueOption<int?> _workers = Values.Whole("--workers", "threads; by default one a processor", 1);
    private static readonly ValueOption<string?> _out = Values.File("--out", "the picture of the best run; by default learned.svg");

    public static Command Create()
    {
        Command command = new("learn", "Balances a pole on a cart by random search in 64 worlds.") { _turns, _seed, _workers, _out };
        command.SetAction(Learn);
        return command;
    }

    private static int Learn(ParseResult words)
    {
        string path = words.GetValue(_out) ?? "learned.svg";
        int workers = words.GetValue(_workers) ?? Environment.ProcessorCount;
        using var batch = new WorldBatch(Worlds, 1, Weights, i => new CartPole(TiltOf(i % Tilts)), workers);
        Console.WriteLine($"{Worlds} worlds on {batch.Workers} workers: {Tries} tries a turn, each from {Tilts} tilts");
        float[] best = Search(batch, words.GetValue(_turns), words.GetValue(_seed));
        Save(path, Draw(best));
        Console.WriteLine($"the best run: {path}");
        return 0;
    }

    private static float TiltOf(int index) => 0.08f * (index < Tilts / 2 ? index - (Tilts / 2) : index - (Tilts / 2) + 1);

    /// <returns>The weights of the best law.</returns>
    private static float[] Search(WorldBatch batch, int turns, int seed)
    {
        var random = new Random(seed);
        var best = new float[Weights];
        var laws = new float[Tries][];
        double bestScore = -1;
        float spread = FirstSpread;
        long started = Stopwatch.GetTimestamp();
        int turn = 0;
        while (turn < turns && bestScore < EpisodeSteps)
        {
            turn++;
            for (int i = 0; i < Tries; i++)
            {
                // The first is the best so far: what was luck with one set of tilts does not stay.
                laws[i] = (float[])best.Clone();
                for (int k = 0; k < Weights && i > 0; k++)
                {
                    laws[i][k] += spread * _scales[k] * Gauss(random);
                }
            }

            double[] scores = Try(batch, laws);
            int first = Array.IndexOf(scores, Max(scores));
            bool better = scores[first] > bestScore;
            bestScore = Math.Max(bestScore, scores[first]);
            best = better ? laws[first] : best;
            spread = better ? spread * 1.3f : spread * 0.85f;
            Console.WriteLine(Progress(turn, bestScore));
        }

        double seconds = Stopwatch.GetElapsedTime(started).TotalSeconds;
        long updates = (long)turn * Worlds * EpisodeSteps;
        Console.WriteLine(string.Create(
            CultureInfo.InvariantCulture, $"{turn} turns, {updates} updates, {updates / seconds:F0} updates a second"));
        return best;
    }

    private static string Progress(int turn, double score)
    {
        double share = Math.Clamp(score / EpisodeSteps, 0, 1);
        int filled = (int)(share * BarWidth);
        return string.Create(
            CultureInfo.InvariantCulture,
            $"turn {turn,3}  [{new string('#', filled)}{new string('.', BarWidth - filled)}]  {score * Dt:F2} of {EpisodeSteps * Dt:F2} s "
                + $"upright");
    }

    /// <summary>Runs all laws from all tilts at once.</summary>
    /// <returns>Mean number of updates for which each keeps its pole upright.</returns>
    private static double[] Try(WorldBatch batch, float[][] laws)
    {
        var actions = new float[Worlds];
        var seen = new float[Worlds * Weights];
        var fallen = new bool[Worlds];
        var scores = new double[Tries];
        batch.ResetAll();
        batch.Observe(seen);
        for (int step = 0; step < EpisodeSteps; step++)
        {
            for (int world = 0; world < Worlds; world++)
            {
                ReadOnlySpan<float> state = seen.AsSpan(world * Weights, Weights);
                fallen[world] |= CartPole.HasFallen(state);
                scores[world / Tilts] += fallen[world] ? 0 : 1.0 / Tilts;
                actions[world] = fallen[world] ? 0 : Law(laws[world / Tilts], state);
            }

            batch.Step(Dt, actions, seen);
        }

        return scores;
    }

    private static float Law(float[] weights, ReadOnlySpan<float> state)
    {
        float sum = 0;
        for (int k = 0; k < Weights; k++)
        {
            sum += weights[k] * state[k];
        }

        return Math.Clamp(sum, -1, 1);
    }

    private static double Max(double[] values)
    {
        double most = values[0];
        foreach (double value in values)
        {
            most = Math.Max(most, value);
        }

        return most;
    }

    // The sum of twelve uniform numbers, less six, is close enough to normal.
    private static float Gauss(Random random)
    {
        float sum = -6;
        for (int i = 0; i < 12; i++)
        {
            sum += random.NextSingle();
        }

        return sum;
    }

    /// <summary>The first seconds of a run from the largest tilt: cart and pole at several moments, the later the darker.</summary>
    private static SvgDebugDraw Draw(float[] weights)
    {
        const int Shown = 150;
        const int Between = 6;
        var world = new CartPole(TiltOf(Tilts - 1));
        var picture = new SvgDebugDraw(new Vector2(-3, -2.6f), new Vector2(3, 0.7f), 1200, 660, yUp: false);
        picture.DrawLine(new Vector2(-3, 0), new Vector2(3, 0), new DebugColor(120, 120, 120));
        var state = new float[Weights];
        var action = new float[1];
        for (int step = 0; step < Shown; step++)
        {
            world.Observe(state);
            if (step % Between == 0)
            {
                byte shade = (byte)(220 - (200 * step / Shown));
                world.Draw(picture, new DebugColor(shade, shade, (byte)Math.Min(255, shade + 60)));
            }

            action[0] = Law(weights, state);
            world.Act(action);
            world.Simulator.Update(Dt);
        }

        return picture;
    }

    private static void Save(string path, SvgDebugDraw picture)
    {
        try
        {
            picture.Save(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new UsageException($"cannot write '{path}': {e.Message.ReplaceLineEndings(" ")}");
        }
    }

    /// <summary>A cart on a rail, pushed along it, and a pole that stands on it by a hinge.</summary>
    private sealed class CartPole : BatchedWorld
    {
        private const float Length = 2;
        private const float Force = 15;
        private const float MostTilt = 0.6f;
        private const float MostWay = 2.5f;

        private readonly Body _cart;
        private readonly Body _pole;

        public CartPole(float tilt)
            : base(new PhysicsSimulator(new Vector2(0, 10)))
        {
            _cart = BodyFactory.Instance.CreateRectangleBody(Simulator, 0.8f, 0.4f, 1);
            _pole = BodyFactory.Instance.CreateRectangleBody(Simulator, 0.1f, Length, 0.2f);
            _pole.Rotation = tilt;
            _pole.Position = 0.5f * Length * new Vector2(MathF.Sin(tilt), -MathF.Cos(tilt));
            JointFactory.Instance.CreateRevoluteJoint(Simulator, _cart, _pole, Vector2.Zero);
            Simulator.Add(new FixedPrismaticJoint(_cart, Vector2.Zero, Vector2.UnitX));
        }

        public static bool HasFallen(ReadOnlySpan<float> state) => MathF.Abs(state[0]) > MostWay || MathF.Abs(state[2]) > MostTilt;

        public override void Act(ReadOnlySpan<float> action) => _cart.ApplyForce(new Vector2(Force * action[0], 0));

        public override void Observe(Span<float> observation)
        {
            observation[0] = _cart.Position.X;
            observation[1] = _cart.LinearVelocity.X;
            observation[2] = _pole.Rotation;
            observation[3] = _pole.AngularVelocity;
        }

        public void Draw(SvgDebugDraw picture, DebugColor color)
        {
            Vector2 cart = _cart.Position;
            var box = new Vertices
            {
                cart + new Vector2(-0.4f, -0.1f), cart + new Vector2(0.4f, -0.1f), cart + new Vector2(0.4f, 0.1f),
                cart + new Vector2(-0.4f, 0.1f),
            };
            picture.DrawPolygon(box, color, color.WithAlpha(60));
            picture.DrawLine(cart, (2 * _pole.Position) - cart, color);
        }
    }
}
