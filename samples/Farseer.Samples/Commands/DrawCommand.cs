using System;
using System.IO;
using Farseer.CommandLines;
using Farseer.Samples.Drawing;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics;
using FarseerGames.FarseerPhysics.Views;

namespace Farseer.Samples.Commands;

/// <summary>Draws one step of a scene into an SVG file.</summary>
internal static class DrawCommand
{
    private const int LongerSide = 1000;
    private const float Moment = 1e-9f;

    public static int Execute(RunOptions options)
    {
        Scene scene = SceneSelection.Find(options.Scene);
        SceneRun run = RunCommand.Start(scene, options);
        while (!run.IsFinished)
        {
            run.Step();
        }

        if (run.Done == 0)
        {
            // Items enter with the first update. One this short shows them where they were put.
            run.Simulator.Update(Moment);
            foreach (SceneCompanion companion in scene.Companions)
            {
                companion.Simulator.Update(Moment);
            }
        }

        SvgDebugDraw picture = Picture(run);
        float mark = 0.03f * Math.Max(scene.View.Max.X - scene.View.Min.X, scene.View.Max.Y - scene.View.Min.Y);
        View(run.Simulator, picture, mark, options.Show).Draw();
        foreach (SceneCompanion companion in scene.Companions)
        {
            View(companion.Simulator, new CompanionDraw(picture, companion), mark / companion.Scale, options.Show).Draw();
        }

        string path = options.Out ?? scene.Name + ".svg";
        try
        {
            picture.Save(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new UsageException($"cannot write '{path}': {e.Message.ReplaceLineEndings(" ")}");
        }

        Console.WriteLine($"{scene.Name} after {run.Done} updates: {path}");
        return 0;
    }

    private static PhysicsSimulatorView View(PhysicsSimulator simulator, IDebugDraw picture, float mark, ShownParts show) =>
        new(simulator, picture)
    {
        MarkLength = mark,
        EnableVerticeView = (show & ShownParts.Vertices) != 0,
        EnableGridView = (show & ShownParts.Grids) != 0,
        EnableAABBView = (show & ShownParts.Boxes) != 0,
        EnableCoordinateAxisView = (show & ShownParts.Axes) != 0,
    };

    private static SvgDebugDraw Picture(SceneRun run)
    {
        SceneView view = run.Scene.View;
        double width = Math.Max(view.Max.X - (double)view.Min.X, 1e-30);
        double height = Math.Max(view.Max.Y - (double)view.Min.Y, 1e-30);
        double scale = LongerSide / Math.Max(width, height);

        // As in the terminal: gravity along +y means a world drawn with y down, as on a screen.
        return new SvgDebugDraw(
            view.Min,
            view.Max,
            Math.Max(1, (int)Math.Ceiling(width * scale)),
            Math.Max(1, (int)Math.Ceiling(height * scale)),
            yUp: run.Simulator.Gravity.Y <= 0);
    }
}
