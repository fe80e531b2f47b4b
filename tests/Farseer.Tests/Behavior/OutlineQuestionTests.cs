using System;
using System.Numerics;
using FarseerGames.FarseerPhysics.Collisions;
using FarseerGames.FarseerPhysics.Dynamics;
using FarseerGames.FarseerPhysics.Factories;
using Xunit;

namespace Farseer.Tests.Behavior;

/// <summary><see cref="Vertices.CheckPolygon"/> says what factories and geoms do.</summary>
public class OutlineQuestionTests
{
    [Fact]
    public void FaultlessOutlines_AreAccepted_AndOthersRefused()
    {
        var random = new Random(11);
        int accepted = 0;
        int refused = 0;
        for (int i = 0; i < 4000; i++)
        {
            Vertices outline = Outline(random);
            PolygonFault fault = outline.CheckPolygon();

            // A repeated vertex is left out; what is left then decides.
            if (fault == PolygonFault.RepeatedVertex)
            {
                continue;
            }

            string what = $"{i}: {fault} for {string.Join(" ", outline)}";
            Assert.True(
                Takes(() => BodyFactory.Instance.CreatePolygonBody(new Vertices(outline), 1)) == (fault == PolygonFault.None), what);
            Assert.True(Takes(() => new Geom(new Body(), new Vertices(outline), 0)) == (fault == PolygonFault.None), what);
            Assert.True(fault == PolygonFault.None == outline.IsSimple(), what);
            _ = fault == PolygonFault.None ? accepted++ : refused++;
        }

        Assert.True(accepted > 500 && refused > 500, $"{accepted} accepted, {refused} refused");
    }

    private static bool Takes(Action make)
    {
        try
        {
            make();
            return true;
        }
        catch (ArgumentException)
        {
            return false;
        }
    }

    /// <summary>Plain, thin, far away, nearly collinear, touching and crossing ones, of three to eight vertices.</summary>
    private static Vertices Outline(Random random)
    {
        float size = MathF.Pow(10, (6 * (float)random.NextDouble()) - 3);
        float thin = random.Next(2) == 0 ? 1 : MathF.Pow(10, -8 * (float)random.NextDouble());
        Vector2 place = random.Next(3) == 0 ? size * MathF.Pow(10, 7 * (float)random.NextDouble()) * Vector2.One : Vector2.Zero;
        bool any = random.Next(3) == 0;
        var outline = new Vertices();
        int corners = random.Next(3, 9);
        for (int k = 0; k < corners; k++)
        {
            double angle = any ? 7 * random.NextDouble() : 2 * Math.PI * k / corners;
            double reach = 0.3 + random.NextDouble();
            outline.Add(place + (size * new Vector2((float)(reach * Math.Cos(angle)), thin * (float)(reach * Math.Sin(angle)))));
        }

        return outline;
    }
}
