using System;
using System.IO;
using Farseer.Samples.Drawing;
using Farseer.Scenes;
using FarseerGames.FarseerPhysics.Views;

namespace Farseer.Samples.Commands;

/// <summary>Draws one step of a scene into an SVG file.</summary>
internal static class DrawCommand
{
    private const int LongerSide = 1000;

    public static int Execute(RunOptions options)
    {
        Scene scene = SceneSelection.Find(options.Scene);
        SceneRun run = RunCommand.Start(scene, options);
        while (!run.IsFinished)
        {
            run.Step();
        }

        SvgDebugDraw picture = Picture(run);
        float mark = 0.03f * Math.Max(scene.View.Max.X - scene.View.Min.X, scene.View.Max.Y - scene.View.Min.Y);
        new PhysicsSimulatorView(run.Simulator, picture) { MarkLength = mark }.Draw();
        foreach (SceneCompanion companion in scene.Companions)
        {
            new PhysicsSimulatorView(companion.Simulator, new CompanionDraw(picture, companion)) { MarkLength = mark / companion.Scale }.Draw();
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
