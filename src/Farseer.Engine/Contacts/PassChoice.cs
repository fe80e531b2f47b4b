using Farseer.Engine.Bodies;

namespace Farseer.Engine.Contacts;

/// <summary>Finds the code of a pass that fits the rows.</summary>
internal static class PassChoice
{
    /// <summary>Runs a pass.</summary>
    /// <param name="pass">The pass.</param>
    /// <param name="rows">Its rows.</param>
    /// <param name="grounded">One body of each contact does not move.</param>
    /// <param name="onePoint">All contacts have one point.</param>
    public static void Run(in ContactPass pass, in BundleList rows, bool grounded, bool onePoint)
    {
        if (grounded)
        {
            Run<ScatterMoving>(pass, rows, onePoint);
        }
        else
        {
            Run<ScatterAll>(pass, rows, onePoint);
        }
    }

    private static void Run<TScatter>(in ContactPass pass, in BundleList rows, bool onePoint)
        where TScatter : struct, IVelocityScatter
    {
        if (onePoint)
        {
            Run<TScatter, OnePoint>(pass, rows);
        }
        else
        {
            Run<TScatter, TwoPoints>(pass, rows);
        }
    }

    private static unsafe void Run<TScatter, TPoints>(in ContactPass pass, in BundleList rows)
        where TScatter : struct, IVelocityScatter
        where TPoints : struct, IContactPoints
    {
        switch (pass.Kind)
        {
            case ContactPassKind.WarmStart:
                ContactKernel.WarmStart<TScatter, TPoints>(rows, pass.States, pass.Coefficients);
                break;
            case ContactPassKind.Biased:
                ContactKernel.SolveBiased<TScatter, TPoints>(rows, pass.States, pass.Coefficients, pass.Flag);
                break;
            case ContactPassKind.PushOut:
                ContactKernel.PushOut<TScatter, TPoints>(rows, pass.States, pass.Coefficients, pass.Rate);
                break;
            case ContactPassKind.Relax:
                ContactKernel.Relax<TScatter, TPoints>(rows, pass.States, pass.Coefficients, pass.Flag, pass.First);
                break;
        }
    }
}
